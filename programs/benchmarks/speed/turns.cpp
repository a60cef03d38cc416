// SPDX-License-Identifier: GPL-3.0-or-later
#include "turns.h"

#include <algorithm>
#include <chrono>

namespace benchmarks {
namespace {

template <class Pick>
double mean_over_cases(const std::vector<std::vector<double>>& times, Pick pick) {
    double sum = 0;
    for (std::vector<double> rounds : times) {
        std::sort(rounds.begin(), rounds.end());
        sum += pick(rounds);
    }
    return sum / double(times.size());
}

}  // namespace

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Contender::best() const {
    return mean_over_cases(times, [](const auto& sorted) { return sorted.front(); });
}

double Contender::median() const {
    return mean_over_cases(times, [](const auto& sorted) {
        const std::size_t n = sorted.size();
        return (sorted[(n - 1) / 2] + sorted[n / 2]) / 2;
    });
}

int take_turns(std::vector<Contender>& contenders, const Turns& turns) {
    const std::size_t n = contenders.size();
    for (Contender& c : contenders)
        c.times.assign(turns.cases, {});
    double spent = 0;
    int round = 0;
    for (; round < turns.most_rounds; ++round) {
        if (round >= turns.least_rounds && spent > turns.budget) break;
        for (std::size_t i = 0; i < turns.cases; ++i)
            for (std::size_t k = 0; k < n; ++k) {
                const std::size_t turn = (k + std::size_t(round) / 2) % n;
                Contender& c = contenders[round % 2 ? n - 1 - turn : turn];
                c.times[i].push_back(seconds([&] { c.run(i); }));
                spent += c.times[i].back();
            }
    }
    return round;
}

}  // namespace benchmarks
