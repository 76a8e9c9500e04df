#pragma once

#include <almath/types/alposition3d.h>
#include <almath/types/alposition6d.h>
#include <almath/types/alrotation.h>
#include <almath/types/altransform.h>
#include <almath/types/alvelocity6d.h>

// What is given in a frame F, as seen from outside, where F is `frame`; and, "Transpose", the other
// way round. But for transforms directions alone are meant: F's place counts for nothing.

namespace AL {
namespace Math {
namespace detail {

inline Position3D turned(const Transform& f, float x, float y, float z) {
  return Position3D(f.r1_c1 * x + f.r1_c2 * y + f.r1_c3 * z,
                    f.r2_c1 * x + f.r2_c2 * y + f.r2_c3 * z,
                    f.r3_c1 * x + f.r3_c2 * y + f.r3_c3 * z);
}

template <class SixNumbers>
SixNumbers turned(const Transform& frame, const SixNumbers& v) {
  const Position3D move = turned(frame, v.at(0), v.at(1), v.at(2));
  const Position3D turn = turned(frame, v.at(3), v.at(4), v.at(5));
  return SixNumbers(move.x, move.y, move.z, turn.x, turn.y, turn.z);
}

}  // namespace detail

inline void changeReferencePosition3D(const Transform& frame, const Position3D& in,
                                      Position3D& out) {
  out = detail::turned(frame, in.x, in.y, in.z);
}
inline void changeReferenceTransposePosition3D(const Transform& frame, const Position3D& in,
                                               Position3D& out) {
  changeReferencePosition3D(frame.inverse(), in, out);
}
/// Both halves are turned as vectors.
inline void changeReferencePosition6D(const Transform& frame, const Position6D& in,
                                      Position6D& out) {
  out = detail::turned(frame, in);
}
inline void changeReferenceTransposePosition6D(const Transform& frame, const Position6D& in,
                                               Position6D& out) {
  out = detail::turned(frame.inverse(), in);
}
inline void changeReferenceVelocity6D(const Transform& frame, const Velocity6D& in,
                                      Velocity6D& out) {
  out = detail::turned(frame, in);
}
inline void changeReferenceTransposeVelocity6D(const Transform& frame, const Velocity6D& in,
                                               Velocity6D& out) {
  out = detail::turned(frame.inverse(), in);
}
/// frame * in, its place too.
inline void changeReferenceTransform(const Transform& frame, const Transform& in, Transform& out) {
  out = frame * in;
}
/// What changeReferenceTransform() makes `in` of. (The formula documented by Aldebaran,
/// frame * in^T, is no transform.)
inline void changeReferenceTransposeTransform(const Transform& frame, const Transform& in,
                                              Transform& out) {
  out = frame.inverse() * in;
}

}  // namespace Math
}  // namespace AL
