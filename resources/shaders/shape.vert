#version 330 core

// One shape of ui/view/shape.h per instance, in device pixels with y down; four corners each.
layout(location = 0) in vec4 points;  // from, to
layout(location = 1) in vec4 edges;   // at from, at to
layout(location = 2) in vec4 sizes;   // half width at from, at to; width of the outline; ends
layout(location = 3) in vec4 color;   // premultiplied, as is the outline's
layout(location = 4) in vec4 outline;

uniform vec2 viewport;  // [device px]

// Where the corner lies: along the axis from its start, and across it [px].
out vec2 place;
flat out float axisLength;
flat out vec4 shapeSizes;
flat out vec4 shapeColor;
flat out vec4 shapeOutline;

const int kJoined = 0;
const int kRound = 1;

void main() {
  bool atEnd = (gl_VertexID & 1) == 1;
  float side = (gl_VertexID & 2) == 2 ? 1.0 : -1.0;
  vec2 axis = points.zw - points.xy;
  axisLength = length(axis);
  vec2 direction = axisLength > 0.0 ? axis / axisLength : vec2(1.0, 0.0);
  vec2 normal = vec2(-direction.y, direction.x);
  float halfWidth = max(sizes.x, sizes.y) + 1.0;  // a pixel of room for the soft edge
  int ends = int(sizes.w);

  vec2 corner = atEnd ? points.zw : points.xy;
  if (ends == kJoined) {
    corner += side * halfWidth * (atEnd ? edges.zw : edges.xy);
  } else {
    float beyond = ends == kRound ? halfWidth : 1.0;
    corner += side * halfWidth * normal + (atEnd ? beyond : -beyond) * direction;
  }

  place = vec2(dot(corner - points.xy, direction), dot(corner - points.xy, normal));
  shapeSizes = sizes;
  shapeColor = color;
  shapeOutline = outline;
  gl_Position = vec4(corner.x / viewport.x * 2.0 - 1.0, 1.0 - corner.y / viewport.y * 2.0, 0.0, 1.0);
}
