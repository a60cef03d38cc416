// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace benchmarks {

/// By the clock.
double seconds(const std::function<void()>& work);

/// Work timed beside other work, on several cases such as views.
struct Contender {
    std::string key, text;  ///< names for programs and for people
    std::function<void(std::size_t)> run;
    std::vector<std::vector<double>> times = {};  ///< seconds, by case and round

    double best() const;    ///< seconds, mean over the cases of the best round
    double median() const;  ///< seconds, mean over the cases of the median round
};

struct Turns {
    std::size_t cases = 1;
    int least_rounds = 3, most_rounds = 20;
    double budget = 20;  ///< seconds after which no further round begins
};

/// Runs all contenders case by case and round by round, so that disturbances hit all: each round
/// starts with another one, every second goes backwards. Returns the number of rounds.
int take_turns(std::vector<Contender>& contenders, const Turns& turns);

}  // namespace benchmarks
