#pragma once

#include <QString>

namespace ui {

/// The languages the program speaks.
enum class Language { kDesktop, kEnglish, kSwedish, kGerman, kFrench, kSpanish };
constexpr int kLanguageCount = 6;

/// What the language calls itself, so that it is found by those who read no other.
/// @pre not kDesktop
QString nameOf(Language language);

/// Makes all texts made from now on appear in this language, Qt's own among them, and numbers in
/// its format. English stands in for texts that are not translated, those of a desktop's language
/// among them; and Qt's own remain English where the system has no translation of them.
///
/// What is on the screen stays as it is: see MainWindow::speak().
/// @pre there is a QCoreApplication
void speak(Language language);

/// A name from a form or a heading as it is written within a sentence: "Air density" becomes
/// "air density", unless the language keeps its capitals.
QString withinSentence(const QString& name);

}  // namespace ui
