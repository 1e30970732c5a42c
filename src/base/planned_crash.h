// Crashes on purpose, for tests of recovery. Scripts plan them: `fault crash drawing stack`.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/names.h"

namespace coaster::base {

enum class CrashPlace : std::uint8_t { input, job, panels, command, ticks, findings, drawing, keeping };
inline constexpr NameRow kCrashPlaces[] = {{"input", "Input", "Reading the events of a frame."},
                                           {"job", "Job", "In the thread of an import or a search."},
                                           {"panels", "Panels", "Building the panels."},
                                           {"command", "Command", "Applying a command."},
                                           {"ticks", "Ticks", "Advancing the ride."},
                                           {"findings", "Findings", "Finding what the picture shows."},
                                           {"drawing", "Drawing", "Drawing the picture."},
                                           {"keeping", "Keeping", "Keeping settings and unsaved changes."}};
constexpr std::span<const NameRow> rows_of(CrashPlace) { return kCrashPlaces; }

enum class CrashWay : std::uint8_t { access, check, exception, stack, memory };
inline constexpr NameRow kCrashWays[] = {{"access", "Access", "Writes to an invalid address."},
                                         {"check", "Check", "Fails a check."},
                                         {"exception", "Exception", "Throws an exception that nobody handles."},
                                         {"stack", "Stack", "Calls itself until the stack ends."},
                                         {"memory", "Memory", "Takes all memory, then writes to an invalid address."}};
constexpr std::span<const NameRow> rows_of(CrashWay) { return kCrashWays; }

struct PlannedCrash {
  CrashPlace place = CrashPlace::input;
  CrashWay way = CrashWay::access;
};

// Crashes if that is planned for this place.
void crash_if_planned(const std::optional<PlannedCrash>& plan, CrashPlace place);

}  // namespace coaster::base
