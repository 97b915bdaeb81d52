#pragma once

#include <QString>

namespace ui {

class Camera;

/// The largest power of ten that is no longer than a pixel of the picture [m]: what a hand can
/// set to and an eye can read.
double finestLength(const Camera& camera);

/// A length [m] with its unit, as exactly as the picture shows it: "1.254 m".
QString lengthText(double metres, const Camera& camera);

}  // namespace ui
