#include "sim/ground/plant_models.h"

#include <cmath>
#include <map>
#include <utility>

#include "sim/ground/noise.h"

namespace coaster::sim {
namespace {

constexpr float kWholeTurn = 6.28318531f;
constexpr glm::vec3 kNeedles{0.050f, 0.125f, 0.050f}, kLeaves{0.110f, 0.205f, 0.045f}, kBark{0.16f, 0.105f, 0.07f},
    kBush{0.115f, 0.195f, 0.055f}, kStone{0.330f, 0.305f, 0.270f};

float random(int a, int b) { return static_cast<float>(random_at(a, b, 11)); }

class ModelBuilder {
 public:
  std::uint16_t vertex(glm::vec3 at, glm::vec3 normal, glm::vec3 paint, float ambient) {
    model_.vertices.push_back({at, land_finish(glm::normalize(normal), paint, ambient)});
    return static_cast<std::uint16_t>(model_.vertices.size() - 1);
  }
  void triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    model_.indices.insert(model_.indices.end(), {a, b, c});
  }

  // A trunk without ends.
  void trunk(int sides, float height, float low, float high) {
    const auto ring = [&](float radius, float y, float ambient) {
      std::vector<std::uint16_t> made;
      for (int i = 0; i < sides; ++i) {
        const float turn = kWholeTurn * static_cast<float>(i) / static_cast<float>(sides);
        const glm::vec3 out(std::cos(turn), 0, std::sin(turn));
        made.push_back(vertex(radius * out + glm::vec3(0, y, 0), out, kBark, ambient));
      }
      return made;
    };
    const std::vector<std::uint16_t> lower = ring(low, -0.6f, 0.5f), upper = ring(high, height, 0.35f);
    for (int i = 0; i < sides; ++i) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>((i + 1) % sides);
      triangle(lower[a], upper[a], upper[b]);
      triangle(lower[a], upper[b], lower[b]);
    }
  }

  // A tier of needles: a cone with an uneven rim and a hollow underside.
  void tier(int index, int tiers, int sides, float uneven) {
    const float f = static_cast<float>(index) / static_cast<float>(tiers);
    const float rim = 1.2f + 7.2f * f, radius = 2.35f * (1 - 0.78f * f);
    const bool last = index + 1 == tiers;
    const float tip = last ? 9.8f : rim + 12.15f / static_cast<float>(tiers);
    const std::uint16_t top = vertex({0, tip, 0}, {0, 1, 0}, kNeedles, last ? 0.95f : 0.45f);
    const std::uint16_t under = vertex({0, rim + 0.5f, 0}, {0, -1, 0}, 0.5f * kNeedles, 0.2f);
    std::vector<std::uint16_t> upper, lower;
    for (int i = 0; i < sides; ++i) {
      const float turn =
          kWholeTurn * (static_cast<float>(i) + 0.37f * static_cast<float>(index)) / static_cast<float>(sides);
      // Branches alternate, so that the outline is jagged.
      const float r = radius * (1 + uneven * (2 * random(i, index) - 1) - (uneven > 0.1f && i % 2 == 1 ? 0.12f : 0.0f));
      const float y = rim + 0.5f * uneven * (2 * random(i + 40, index) - 1);
      const glm::vec3 at(r * std::cos(turn), y, r * std::sin(turn));
      const glm::vec3 soft = glm::normalize(glm::vec3(at.x, 0.55f * r, at.z)),
                      face = glm::normalize(glm::vec3(at.x / r, r / (tip - rim), at.z / r));
      upper.push_back(vertex(at, 0.55f * soft + 0.45f * face, 1.15f * kNeedles, 0.85f));
      lower.push_back(vertex(at, {0.2f * at.x, -1, 0.2f * at.z}, 0.7f * kNeedles, 0.4f));
    }
    for (int i = 0; i < sides; ++i) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>((i + 1) % sides);
      triangle(upper[a], top, upper[b]);
      triangle(lower[a], lower[b], under);
    }
  }

  // A ball of `splits` times divided faces of an icosahedron.
  struct Ball {
    glm::vec3 middle{0}, radii{1};
    int splits = 0, seed = 0;
    float uneven = 0.14f;
  };
  template <class Look>
  void ball(const Ball& ball, const Look& look) {
    constexpr float t = 1.618034f;
    std::vector<glm::vec3> points{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                                  {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
    std::vector<std::array<std::uint16_t, 3>> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (glm::vec3& point : points) point = glm::normalize(point);
    for (int split = 0; split < ball.splits; ++split) {
      std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> middles;
      std::vector<std::array<std::uint16_t, 3>> finer;
      const auto middle = [&](std::uint16_t a, std::uint16_t b) {
        const auto [at, made] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint16_t>(points.size()));
        if (made) points.push_back(glm::normalize(points[a] + points[b]));
        return at->second;
      };
      for (const auto& [a, b, c] : faces) {
        const std::uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
      }
      faces = std::move(finer);
    }
    const auto first = static_cast<std::uint16_t>(model_.vertices.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float r = 1 + ball.uneven * (2 * random(static_cast<int>(i), ball.seed) - 1);
      const glm::vec3 at = ball.middle + r * ball.radii * points[i];
      look(*this, at, glm::normalize(points[i] / ball.radii));
    }
    for (const auto& [a, b, c] : faces)
      triangle(static_cast<std::uint16_t>(first + a), static_cast<std::uint16_t>(first + b),
               static_cast<std::uint16_t>(first + c));
  }

  PlantModel take() { return std::move(model_); }

 private:
  PlantModel model_;
};

PlantModel conifer(PlantLevel level) {
  ModelBuilder model;
  switch (level) {
    case PlantLevel::near:
      model.trunk(7, 2, 0.26f, 0.17f);
      for (int i = 0; i < 8; ++i) model.tier(i, 8, 18, 0.24f);
      break;
    case PlantLevel::fine:
      model.trunk(5, 2, 0.26f, 0.17f);
      for (int i = 0; i < 4; ++i) model.tier(i, 4, 8, 0.22f);
      break;
    case PlantLevel::coarse:
      model.trunk(3, 2, 0.26f, 0.17f);
      for (int i = 0; i < 3; ++i) model.tier(i, 3, 5, 0.08f);
      break;
    case PlantLevel::far: model.tier(0, 1, 5, 0.05f); break;
  }
  return model.take();
}

constexpr auto kLeafLook = [](ModelBuilder& model, glm::vec3 at, glm::vec3 out) {
  const float u = glm::clamp((at.y - 2.6f) / 5, 0.0f, 1.0f);
  const glm::vec3 away = glm::normalize(at - glm::vec3(0, 4.6f, 0));
  model.vertex(at, away + out, (0.9f + 0.25f * u) * kLeaves, 0.45f + 0.55f * u);
};

PlantModel broadleaf(PlantLevel level) {
  ModelBuilder model;
  constexpr ModelBuilder::Ball kFine[] = {{{0, 5.6f, 0}, glm::vec3(2.5f), 0, 1},
                                          {{1.5f, 4.4f, 0.7f}, {1.7f, 1.5f, 1.7f}, 0, 2},
                                          {{-1.2f, 4.6f, 1.0f}, {1.8f, 1.6f, 1.8f}, 0, 3},
                                          {{-0.3f, 4.3f, -1.6f}, {1.8f, 1.5f, 1.8f}, 0, 4}};
  switch (level) {
    case PlantLevel::near:
    case PlantLevel::fine:
      model.trunk(level == PlantLevel::near ? 8 : 5, 3.6f, 0.26f, 0.17f);
      for (ModelBuilder::Ball ball : kFine) {
        if (level == PlantLevel::near) ball.splits = 1, ball.uneven = 0.13f;
        model.ball(ball, kLeafLook);
      }
      break;
    case PlantLevel::coarse:
      model.trunk(3, 3.6f, 0.26f, 0.17f);
      model.ball({{0.3f, 5.5f, 0.2f}, {2.5f, 2.3f, 2.5f}, 0, 5}, kLeafLook);
      model.ball({{-0.5f, 4.1f, -0.3f}, {2.6f, 1.5f, 2.6f}, 0, 6}, kLeafLook);
      break;
    case PlantLevel::far: model.ball({{0, 5.0f, 0}, {2.8f, 2.6f, 2.8f}, 0, 7, 0.1f}, kLeafLook); break;
  }
  return model.take();
}

PlantModel bush(PlantLevel level) {
  ModelBuilder model;
  const auto look = [](ModelBuilder& to, glm::vec3 at, glm::vec3 out) {
    const float u = glm::clamp(at.y / 1.3f, 0.0f, 1.0f);
    to.vertex(at, out + glm::vec3(0, 0.3f, 0), (0.85f + 0.3f * u) * kBush, 0.4f + 0.6f * u);
  };
  if (level <= PlantLevel::fine) {
    const int splits = level == PlantLevel::near ? 1 : 0;
    model.ball({{0, 0.55f, 0}, {0.95f, 0.8f, 0.95f}, splits, 21, 0.17f}, look);
    model.ball({{0.7f, 0.35f, 0.35f}, {0.65f, 0.55f, 0.6f}, splits, 22, 0.17f}, look);
  } else {
    model.ball({{0.2f, 0.45f, 0.1f}, {1.15f, 0.75f, 1.05f}, 0, 23, 0.1f}, look);
  }
  return model.take();
}

PlantModel rock(PlantLevel level) {
  ModelBuilder model;
  const auto look = [](ModelBuilder& to, glm::vec3 at, glm::vec3 out) {
    const float u = glm::clamp(0.5f + at.y, 0.0f, 1.0f);
    to.vertex(at, out, (0.8f + 0.3f * random(static_cast<int>(40 * at.x), static_cast<int>(40 * at.z))) * kStone,
              0.5f + 0.5f * u);
  };
  model.ball({{0, 0.25f, 0}, {1.0f, 0.65f, 0.8f}, level == PlantLevel::near ? 1 : 0, 31, 0.22f}, look);
  return model.take();
}

}  // namespace

PlantModel plant_model(PlantKind kind, PlantLevel level) {
  switch (kind) {
    case PlantKind::conifer: return conifer(level);
    case PlantKind::broadleaf: return broadleaf(level);
    case PlantKind::bush: return bush(level);
    case PlantKind::rock: return rock(level);
  }
  return {};
}

PlantModel meadow_model(std::size_t kind) {
  constexpr glm::vec3 kBlade{0.185f, 0.290f, 0.070f};
  constexpr glm::vec3 kPetals[kMeadowKinds] = {
      kBlade, {0.80f, 0.76f, 0.70f}, {0.85f, 0.58f, 0.05f}, {0.42f, 0.16f, 0.55f}};
  ModelBuilder model;
  const glm::vec3 up(0, 1, 0);
  const int blades = kind == 0 ? 6 : 4;
  for (int i = 0; i < blades; ++i) {
    const float turn = kWholeTurn * (static_cast<float>(i) + 0.6f * random(i, 61)) / static_cast<float>(blades);
    const glm::vec3 out(std::cos(turn), 0, std::sin(turn)), aside(-out.z, 0, out.x);
    const glm::vec3 root = 0.10f * random(i, 62) * out;
    const glm::vec3 tip = root + (0.08f + 0.16f * random(i, 63)) * out + (0.20f + 0.16f * random(i, 64)) * up;
    const std::uint16_t low = model.vertex(root - 0.026f * aside, up, 0.8f * kBlade, 0.6f),
                        side = model.vertex(root + 0.026f * aside, up, 0.8f * kBlade, 0.6f),
                        top = model.vertex(tip, up, 1.15f * kBlade, 1.0f);
    model.triangle(low, side, top);
    if (kind == 0 || i % 2 == 1) continue;
    const glm::vec3 head = tip + 0.03f * up;  // a petal on each side of it
    for (const float way : {-1.0f, 1.0f}) {
      const std::uint16_t a = model.vertex(head, up, kPetals[kind], 1),
                          b = model.vertex(head + way * 0.055f * aside + 0.03f * up, up, kPetals[kind], 1),
                          c = model.vertex(head + way * 0.02f * aside + 0.05f * out, up, kPetals[kind], 0.9f);
      model.triangle(a, b, c);
    }
  }
  return model.take();
}

PlantLevel plant_level(float metres) {
  for (std::size_t level = 0; level + 1 < kPlantLevels; ++level)
    if (metres < kPlantReach[level]) return static_cast<PlantLevel>(level);
  return PlantLevel::far;
}

}  // namespace coaster::sim
