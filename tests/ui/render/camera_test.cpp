#include "ui/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec4.hpp>
#include <limits>
#include <random>

#include "test_layers.h"

namespace planewright::render {
namespace {

const Vector3d kLow(-3.0, 2.0, 1.0), kHigh(5.0, 3.0, 9.0);

Vector3d corner(int i) {
  return {((i & 1) ? kHigh : kLow).x(), ((i & 2) ? kHigh : kLow).y(), ((i & 4) ? kHigh : kLow).z()};
}

Camera fitted(int width = 1200, int height = 800) {
  Camera camera;
  camera.set_viewport(width, height);
  camera.fit(kLow, kHigh);
  return camera;
}

void expect_near(glm::vec2 a, glm::vec2 b, float tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

TEST(Camera, FitHoldsTheBoxFromEverywhereInAnyViewport) {
  for (const auto& [width, height] : {std::pair{1600, 900}, std::pair{300, 900}, std::pair{500, 500}}) {
    for (double azimuth : {-3.0, -1.2, 0.0, 0.7, 2.4}) {
      for (double elevation : {-1.5, -0.4, 0.0, 0.5, 1.5}) {
        Camera camera;
        camera.set_viewport(width, height);
        camera.set_direction(azimuth, elevation);
        camera.fit(kLow, kHigh);
        glm::vec2 low(1e9f), high(-1e9f);
        for (int i = 0; i < 8; ++i) {
          const glm::vec2 p = camera.project(corner(i));
          low = {std::min(low.x, p.x), std::min(low.y, p.y)};
          high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
        EXPECT_GT(low.x, 0.0f);
        EXPECT_GT(low.y, 0.0f);
        EXPECT_LT(high.x, static_cast<float>(width));
        EXPECT_LT(high.y, static_cast<float>(height));
        // Tight: it fills most of the picture in one direction at least, and stands in its middle.
        EXPECT_GT(std::max((high.x - low.x) / static_cast<float>(width),
                           (high.y - low.y) / static_cast<float>(height)),
                  0.85f);
      }
    }
  }
}

TEST(Camera, NearAndFarHoldTheBox) {
  const Camera camera = fitted();
  for (int i = 0; i < 8; ++i) {
    const Vector3d p = corner(i);
    const glm::vec4 clip = camera.projection() * camera.view() * glm::vec4(p.x(), p.y(), p.z(), 1.0f);
    EXPECT_LT(std::abs(clip.z), clip.w);
  }
}

TEST(Camera, MatricesAgreeWithProject) {
  const Camera camera = fitted();
  for (int i = 0; i < 8; ++i) {
    const Vector3d p = corner(i);
    const glm::vec4 clip = camera.projection() * camera.view() * glm::vec4(p.x(), p.y(), p.z(), 1.0f);
    expect_near(camera.project(p), {(clip.x / clip.w + 1.0f) * 600.0f, (1.0f - clip.y / clip.w) * 400.0f},
                0.02f);
  }
}

TEST(Camera, RayAndProjectAreInverse) {
  const Camera camera = fitted();
  std::mt19937 random(1);
  std::uniform_real_distribution<float> x(0.0f, 1200.0f), y(0.0f, 800.0f);
  for (int i = 0; i < 200; ++i) {
    const glm::vec2 pixel(x(random), y(random));
    const Ray ray = camera.ray(pixel);
    EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-12);
    for (double distance : {0.5, 7.0, 300.0}) {
      expect_near(camera.project(ray.origin + distance * ray.direction), pixel, 1e-3f);
    }
  }
}

TEST(Camera, TheTopOfTheScreenIsUp) {
  const Camera camera = fitted();
  const Vector3d centre = 0.5 * (kLow + kHigh);
  EXPECT_LT(camera.project(centre + Vector3d::UnitZ()).y, camera.project(centre).y);
}

TEST(Camera, TheStandardViewLooksFromAboveFrontLeft) {
  Camera camera = fitted();
  camera.set_direction(1.0, -0.3);
  camera.reset_direction();
  EXPECT_GT(camera.forward().x(), 0.2);
  EXPECT_GT(camera.forward().y(), 0.2);
  EXPECT_LT(camera.forward().z(), -0.2);
}

TEST(Camera, OrbitKeepsThePivotOnTheScreen) {
  Camera camera = fitted();
  const Vector3d pivot = corner(3);
  const glm::vec2 before = camera.project(pivot);
  const double depth = camera.depth(pivot);
  for (const glm::vec2 drag :
       {glm::vec2(50, 0), glm::vec2(-20, 30), glm::vec2(0, 5000), glm::vec2(900, -9000)}) {
    camera.orbit(drag, pivot);
    expect_near(camera.project(pivot), before, 0.01f);
    EXPECT_NEAR(camera.depth(pivot), depth, 1e-9);
    EXPECT_GT(camera.up().z(), 0.0);  // never over the pole
  }
}

TEST(Camera, OrbitTurnsWhatIsNearWithTheMouse) {
  Camera camera = fitted();
  const Vector3d pivot = 0.5 * (kLow + kHigh);
  const Vector3d nearer = pivot - 2.0 * camera.forward();
  const glm::vec2 before = camera.project(nearer);
  camera.orbit({30, 0}, pivot);
  EXPECT_GT(camera.project(nearer).x, before.x);
}

TEST(Camera, PanMovesTheAnchorWithTheMouse) {
  Camera camera = fitted();
  const Vector3d anchor = corner(6);
  const glm::vec2 before = camera.project(anchor);
  camera.pan({37, -21}, anchor);
  expect_near(camera.project(anchor), before + glm::vec2(37, -21), 0.01f);
}

TEST(Camera, ZoomKeepsWhatIsUnderThePixel) {
  Camera camera = fitted();
  const glm::vec2 pixel(200, 650);
  const Ray ray = camera.ray(pixel);
  const Vector3d far_there = ray.origin + 40.0 * ray.direction;
  const double size = camera.pixel_size_at(camera.target());
  camera.zoom(1.5, pixel);
  expect_near(camera.project(far_there), pixel, 0.01f);
  EXPECT_NEAR(camera.pixel_size_at(camera.target()), size / 1.5, 1e-9);
}

TEST(Camera, ZoomToAnAnchorKeepsItAndGoesAsNearAsOneLikes) {
  Camera camera = fitted();
  const Vector3d anchor = corner(5);
  const glm::vec2 before = camera.project(anchor);
  for (int i = 0; i < 60; ++i) camera.zoom(1.2, anchor);
  expect_near(camera.project(anchor), before, 0.05f);
  EXPECT_LT(camera.pixel_size_at(anchor), 1e-4);
  const glm::vec4 clip =
      camera.projection() * camera.view() * glm::vec4(anchor.x(), anchor.y(), anchor.z(), 1.0f);
  EXPECT_LT(std::abs(clip.z), clip.w);  // the near plane does not cut it off
}

TEST(Camera, ZoomEndsSomewhereAndNonsenseIsIgnored) {
  Camera camera = fitted();
  for (int i = 0; i < 10000; ++i) camera.zoom(1.2, glm::vec2(600, 400));
  EXPECT_TRUE(camera.eye().allFinite());
  for (int i = 0; i < 10000; ++i) camera.zoom(0.8, glm::vec2(10, 10));
  EXPECT_TRUE(camera.eye().allFinite());
  const Vector3d eye = camera.eye();
  for (double factor :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    camera.zoom(factor, glm::vec2(1, 1));
    camera.zoom(factor, corner(0));
    EXPECT_EQ(camera.eye(), eye);
  }
}

TEST(Camera, PixelSizeIsWhatOnePixelCovers) {
  const Camera camera = fitted();
  const Vector3d p = corner(2);
  const double size = camera.pixel_size_at(p);
  expect_near(camera.project(p + 10.0 * size * camera.right()), camera.project(p) + glm::vec2(10, 0), 0.01f);
}

TEST(Camera, FitsOddThings) {
  Camera camera = fitted();
  const Vector3d eye = camera.eye();
  camera.fit(Vector3d::Constant(1.0), Vector3d::Constant(std::nan("")));
  EXPECT_EQ(camera.eye(), eye);
  camera.fit(kHigh, kLow);
  EXPECT_EQ(camera.eye(), eye);
  camera.fit(Points(0, 3));
  EXPECT_EQ(camera.eye(), eye);

  camera.fit(rows({{2, 2, 2}}));
  EXPECT_TRUE(camera.eye().allFinite());
  expect_near(camera.project({2, 2, 2}), {600, 400}, 0.1f);

  const Vector3d into = 3.0 * camera.forward();
  camera.fit(rows({{0, 0, 0}, into}));  // one behind the other
  expect_near(camera.project({0, 0, 0}), {600, 400}, 0.1f);

  camera.fit(rows({{0, 0, 0}, {std::nan(""), 0, 0}, {1, 1, 1}}));
  expect_near(0.5f * (camera.project({0, 0, 0}) + camera.project({1, 1, 1})), {600, 400}, 1.0f);
}

TEST(Camera, WhatIsBehindTheEyeProjectsFarOutside) {
  const Camera camera = fitted();
  const glm::vec2 p = camera.project(camera.eye() - 3.0 * camera.forward());
  EXPECT_TRUE(p.x < -1000.0f && p.y < -1000.0f);
  EXPECT_LT(camera.depth(camera.eye() - 3.0 * camera.forward()), 0.0);
}

TEST(Camera, GoesFromOneViewToAnother) {
  Camera from, to;
  for (Camera* camera : {&from, &to}) {
    camera->set_viewport(800, 600);
    camera->fit(Vector3d(-1, -2, -3), Vector3d(3, 2, 1));
  }
  const Vector3d place(1, 1, 0);
  to.set_direction(3.0, 0.2);
  to.pan(glm::vec2(400, 300) - to.project(place), place);
  to.zoom(20.0, place);
  EXPECT_LT((Camera::between(from, to, 0.0).eye() - from.eye()).norm(), 1e-9);
  EXPECT_LT((Camera::between(from, to, 1.0).eye() - to.eye()).norm(), 1e-9);
  double before = from.depth(place);
  for (int i = 1; i <= 10; ++i) {
    const Camera on_the_way = Camera::between(from, to, 0.1 * i);
    const double depth = on_the_way.depth(place);
    EXPECT_LT(depth, before);
    EXPECT_GT(depth, 0.0);
    before = depth;
  }
}

}  // namespace
}  // namespace planewright::render
