// Makes a joint G2: of two arcs with radii of about 10 and 20 m, whose curvature jumps where they meet, the smallest
// change of five control points that gives both sides one curvature.
#include <cstddef>
#include <cstdio>
#include <string>

#include <coaster/curve/continuity.h>
#include <coaster/curve/g2.h>

namespace curve = coaster::curve;

void print(const char* name, const curve::Cubic& c) {
  std::printf("%s", name);
  for (const glm::vec3 p : {c.p0, c.p1, c.p2, c.p3}) std::printf(" %.9g %.9g %.9g", p.x, p.y, p.z);
  std::printf("\n");
}

void print(const char* when, const curve::JointContinuity& j) {
  const auto class_of = static_cast<std::size_t>(j.geometric);
  std::printf("%s_jump %.9e\n%s_class %s\n", when, j.curvature_jump, when,
              std::string(curve::rows_of(j.geometric)[class_of].name).c_str());
}

int main() {
  // Quarter circles: handles of 0.5523 radii.
  curve::Cubic before{{-10, 10, 0}, {-10, 4.477f, 0}, {-5.523f, 0, 0}, {0, 0, 0}};
  curve::Cubic after{{0, 0, 0}, {11.046f, 0, 0}, {20, 8.954f, 2}, {20, 20, 4}};
  print("before", curve::joint(before, after));

  const auto side = [](glm::dvec3 anchor, glm::dvec3 handle) {
    curve::G2Side s;
    s.anchor = anchor, s.length = glm::distance(anchor, handle), s.direction = (handle - anchor) / s.length;
    s.length_fixed = false;
    return s;
  };
  curve::G2Problem problem;
  problem.in_handle = before.p2, problem.position = before.p3, problem.out_handle = after.p1;
  problem.before = side(before.p0, before.p1), problem.after = side(after.p3, after.p2);
  const curve::G2Solution found = curve::solve_g2(problem);
  std::printf("solved %d\nmovement %.9f\n", found.outcome == curve::G2Outcome::solved, found.movement);

  before.p1 = problem.before.anchor + problem.before.direction * found.before_length;
  before.p2 = found.in_handle, before.p3 = after.p0 = found.position, after.p1 = found.out_handle;
  after.p2 = problem.after.anchor + problem.after.direction * found.after_length;
  print("after", curve::joint(before, after));
  print("first", before), print("second", after);
}
