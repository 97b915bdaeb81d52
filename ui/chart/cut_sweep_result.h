#pragma once

#include <vector>

#include <QString>

#include "core/aim/cut_sweep.h"

namespace ui {

/// A computed sweep, ready to be shown.
struct CutSweepResult {
  core::CutSweepQuestion question;
  core::Solver solver;
  core::Room room;
  QString sceneName;
  std::vector<core::Landing> landings;  ///< in order of cut times
  bool isResolved = true;               ///< see CutSweep
  core::Target target;
  std::vector<core::Hit> hits;  ///< on that target, the easiest first: the longest
};

/// Method, weight and what the reader must know of the curve, in one or two sentences.
QString sweepNote(const CutSweepResult& result);

/// What was found, for the one who asks when to cut.
QString foundWords(const CutSweepResult& result);

/// What happened on the way to the floor: "off a wall"; empty where nothing did.
QString firstHitWords(core::FirstHit hit);

/// A cut time in three digits after the point.
QString cutTimeText(double time);

/// All landings as a table for spreadsheets: a heading, then one row a landing. Numbers read
/// back exactly.
QString sweepTable(const CutSweepResult& result, QChar separator, const QString& decimalPoint);

}  // namespace ui
