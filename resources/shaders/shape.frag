#version 330 core

// The same formula stands in ui/view/shape_raster.cpp: change both.
in vec2 place;
flat in float axisLength;
flat in vec4 shapeSizes;
flat in vec4 shapeColor;
flat in vec4 shapeOutline;

out vec4 fragment;

const int kRound = 1;
const int kFlat = 2;

void main() {
  int ends = int(shapeSizes.w);
  float onAxis = clamp(place.x, 0.0, axisLength);
  float share = axisLength > 0.0 ? onAxis / axisLength : 0.0;
  float halfWidth = mix(shapeSizes.x, shapeSizes.y, share);
  float distance = ends == kRound ? length(vec2(place.x - onAxis, place.y)) : abs(place.y);
  float coverage = clamp(halfWidth - distance + 0.5, 0.0, 1.0);
  if (ends == kFlat)
    coverage *= clamp(place.x + 0.5, 0.0, 1.0) * clamp(axisLength - place.x + 0.5, 0.0, 1.0);
  float outlineWidth = shapeSizes.z;
  float outlined =
      outlineWidth > 0.0 ? clamp(distance - halfWidth + outlineWidth + 0.5, 0.0, 1.0) : 0.0;
  fragment = mix(shapeColor, shapeOutline, outlined) * coverage;
}
