#pragma once

#include <QByteArray>

namespace tests {

/// A scene file: a weight in flight without air, where every step of RK4 is exact but for rounding.
inline const QByteArray kThrown = R"({"format": "angry-cuts/scene", "version": 1, "gravity": 10,
    "airDensity": 0, "room": {"width": 10, "height": 10, "restitution": 0.5},
    "weights": [{"mass": 2, "radius": 0.5, "position": [1, 5.5], "velocity": [1, 0]}]})";

}  // namespace tests
