// The showcase of all effects, maps/effects.toml, with its flythrough.
#pragma once
#include <gtest/gtest.h>

#include "base/files.h"
#include "flight/flight.h"
#include "formats/script.h"
#include "map/load.h"

namespace enfilade::test {

class Showcase : public testing::Test {
protected:
    void SetUp() override {
        const std::string maps = std::string(ENFILADE_SOURCE_DIR) + "/maps/";
        loaded_ = load_map(maps + "effects.toml", {}, read_file);
        ASSERT_TRUE(loaded_.map);
        flight_ = plan();
        ASSERT_TRUE(flight_);
    }

    /// The flight, planned anew.
    std::optional<Flight> plan() const {
        const auto bytes = read_file(std::string(ENFILADE_SOURCE_DIR) + "/maps/flythroughs/effects.toml");
        if (!bytes.ok()) return {};
        Findings findings;
        return Flight::plan(read_script(as_text(bytes.value())).script, *loaded_.map, findings);
    }

    LoadedMap loaded_;
    std::optional<Flight> flight_;
};

}  // namespace enfilade::test
