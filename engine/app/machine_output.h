// What commands say to other programs instead of to people: JSON (schemas in maps/*.schema.json), SARIF for findings
// and JUnit for flythroughs, which CI systems read.
#pragma once
#include <string>
#include <vector>

#include "app/bench.h"
#include "app/recorded_flight.h"
#include "base/finding.h"
#include "formats/dials.h"

namespace enfilade {

/// A map with all that `check` has to say about it.
struct CheckedMap {
    std::string path;
    Findings findings;
    bool is_refused = false;
};

/// How many findings of that severity all of them have.
std::size_t count_of(const std::vector<CheckedMap>& maps, Severity severity);

/// maps/check.schema.json.
std::string check_json(const std::vector<CheckedMap>& maps);

/// SARIF 2.1.0, one result for each finding.
std::string check_sarif(const std::vector<CheckedMap>& maps);

/// What `fly --check` did.
struct CheckedFlight {
    std::string script, renderer;
    std::string compared_with;  ///< "recording", or the name of another renderer
    int first = 0, last = 0;    ///< frames, both included
    FlightVerdict verdict;
};

/// maps/fly.schema.json.
std::string flight_json(const CheckedFlight& flight);

/// JUnit's XML, one test case for each frame.
std::string flight_junit(const CheckedFlight& flight);

/// How `bench` measured.
struct BenchSetting {
    std::vector<std::string> subjects;
    int width = 0, height = 0;  ///< [px]
    std::string renderer, kernels;
    Dials dials;
    std::size_t threads = 1, rounds = 1;
};

/// maps/bench.schema.json.
std::string bench_json(const BenchSetting& setting, const std::vector<BenchFrame>& frames);

}  // namespace enfilade
