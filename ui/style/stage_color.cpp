#include "ui/style/stage_color.h"

#include <array>

#include "ui/style/theme.h"

namespace ui {

QColor stageColor(std::size_t index, const Theme& theme) {
  // As many as dopri5 has slopes, from the color-blind-safe set of the curves.
  const std::array colors{theme.potential,     theme.kinetic,     theme.lostToAir,
                          theme.lostToImpacts, theme.lostToRopes, theme.lostToFriction,
                          theme.drift};
  return colors[index % colors.size()];
}

}  // namespace ui
