// Compares a quantity of rides with its closed form.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace coaster::test {

// A quantity by the ride and by its closed form. At the end no value may differ by more than `bound`. With RIDE_TRUTH
// set to a folder the values are written there.
class Comparison {
 public:
  Comparison(std::string name, std::string unit, double bound)
      : name_(std::move(name)), unit_(std::move(unit)), bound_(bound) {}
  void add(const std::string& method, std::string series, double x, double ride, double closed) {
    rows_.push_back({method, std::move(series), x, ride, closed, std::abs(ride - closed) / bound_});
  }
  ~Comparison() {
    EXPECT_GT(rows_.size(), 5u) << name_;
    const Row* worst = nullptr;
    for (const Row& row : rows_)
      if (!worst || row.of_bound > worst->of_bound || std::isnan(row.of_bound)) worst = &row;
    if (worst) {
      EXPECT_LT(worst->of_bound, 1) << name_ << " of " << worst->series << " by " << worst->method << " at " << worst->x
                                    << ": " << worst->ride << " is not " << worst->closed;
    }
    const char* const folder = std::getenv("RIDE_TRUTH");
    if (!folder) return;
    std::ofstream file(std::string(folder) + "/" + name_ + ".csv");
    file.precision(12);
    file << unit_ << "\n";
    for (const Row& row : rows_)
      file << row.method << "," << row.series << "," << row.x << "," << row.ride << "," << row.closed << "\n";
  }

 private:
  struct Row {
    std::string method, series;
    double x, ride, closed, of_bound;
  };
  std::string name_, unit_;
  double bound_;
  std::vector<Row> rows_;
};

}  // namespace coaster::test
