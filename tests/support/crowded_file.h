#pragma once

#include <QByteArray>

/// A scene file with this many weights in flight, none near another, in a single line; some
/// 55 bytes each.
/// @param last  what stands behind them in the list; empty: nothing
inline QByteArray oneLineOf(int weights, const QByteArray& last = {}) {
  constexpr int kColumns = 1000;
  QByteArray text =
      R"({"format": "angry-cuts/scene", "version": 1, "gravity": 0, "airDensity": 0, )"
      R"("room": {"width": 1001, "height": 1001}, "weights": [)";
  for (int i = 0; i < weights; ++i) {
    text += i == 0 ? "" : ", ";
    text += R"({"mass": 0.19, "position": [)" + QByteArray::number(i % kColumns + 1) + ", " +
            QByteArray::number(i / kColumns + 1) + R"(], "velocity": [0.1, 0.2]})";
  }
  if (!last.isEmpty()) text += ", " + last;
  return text + "]}";
}
