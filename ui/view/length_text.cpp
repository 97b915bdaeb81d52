#include "ui/view/length_text.h"

#include <cmath>

#include "ui/view/camera.h"
#include "ui/view/ruler.h"

namespace ui {

double finestLength(const Camera& camera) {
  return std::pow(10.0, std::floor(-std::log10(camera.scale())));
}

QString lengthText(double metres, const Camera& camera) {
  Ruler ruler = rulerFor(finestLength(camera), camera.visibleMetres().height());
  ruler.spacing = finestLength(camera);
  const QString text = ruler.textAt(metres);
  return metres < 0 ? QString(text).replace('-', QChar(0x2212)) : text;
}

}  // namespace ui
