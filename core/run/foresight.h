#pragma once

#include <optional>

#include "core/contact/first_contact.h"
#include "core/methods/method.h"
#include "core/run/event_queue.h"
#include "core/run/piece.h"
#include "core/scene/scene.h"

namespace core {

/// What the paths of one step say will happen: moments to be polished by whoever acts on
/// them. Times count from the start of the step [s].
class Foresight {
 public:
  /// One foreseen moment of one or two weights.
  struct Moment {
    double time;
    bool pressing = false;  ///< see Contact
  };
  struct WallMoment : Moment {
    Upcoming::Kind wall;
  };

  /// @param shape      of the method's paths
  /// @param closeness  paths that are no cubics are cut until cubics are this close [m]
  Foresight(const Scene& scene, PathShape shape, const ContactTolerance& tolerance,
            double closeness)
      : m_room(scene.room),
        m_gravity(scene.gravity),
        m_shape(shape),
        m_tolerance(tolerance),
        m_closeness(closeness) {}

  /// First contact of two weights within both pieces.
  std::optional<Moment> meeting(const Body& a, const Piece& pieceA, const Body& b,
                                const Piece& pieceB) const;

  /// First contact with any of the four walls within the piece.
  /// @param box  boxOf() the whole piece
  std::optional<WallMoment> wall(const Body& body, const Piece& piece, const Box& box) const;

  /// First moment where the rope's angular velocity passes zero, after the one before if the
  /// piece holds one.
  std::optional<double> turningPoint(const Piece& piece, std::optional<double> before) const;

  /// Moment where the speed of a flight straight up passes zero; nothing for flights that
  /// keep moving sideways.
  std::optional<double> apex(const Piece& piece) const;

  /// First moment where the tension of the rope falls to zero.
  std::optional<double> slack(const Body& body, const Piece& piece) const;

  /// First moment where a slack rope is stretched to its length.
  std::optional<double> taut(const Body& body, const Piece& piece) const;

  /// First moment where a slide comes to a stop.
  std::optional<double> stop(const Piece& piece) const;

  /// Tension over mass, g cos θ + L ω² [m/s²].
  double tension(const Body& body, const Entries& state) const;

 private:
  /// The path is not to be taken for the cubic through both ends.
  bool isCoarse(const Body& body, const Piece& piece, double from, double to) const;
  bool isInside(const Box& box) const;
  bool ropesKeepApart(const Body& a, const Piece& pieceA, const Body& b, const Piece& pieceB) const;
  std::optional<Moment> meetingBetween(const Body& a, const Piece& pieceA, const Body& b,
                                       const Piece& pieceB, double from, double to) const;
  std::optional<WallMoment> wallBetween(const Body& body, const Piece& piece, double from,
                                        double to) const;
  std::optional<double> slackBetween(const Body& body, const Piece& piece, double from,
                                     double to) const;
  std::optional<double> tautBetween(const Body& body, const Piece& piece, double from, double to,
                                    double outward) const;

  Room m_room;
  double m_gravity;
  PathShape m_shape;
  ContactTolerance m_tolerance;
  double m_closeness;
};

}  // namespace core
