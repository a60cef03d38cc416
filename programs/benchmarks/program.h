// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace benchmarks {

struct Option {
    std::string name;  ///< "--noise 0,10,20": with what stands for its value, if it has one
    std::string help;
    std::function<void(const std::string&)> set;  ///< std::invalid_argument for a wrong value
};

/// The variable outlives the option.
Option flag(const std::string& name, const std::string& help, bool& value);
Option text(const std::string& name, const std::string& help, std::string& value);
Option number(const std::string& name, const std::string& help, double& value, double least = 0,
              double most = std::numeric_limits<double>::max());
Option number(const std::string& name, const std::string& help, int& value, double least = 0);
/// Separated by commas, none below 0.
Option numbers(const std::string& name, const std::string& help, std::vector<double>& values);

/// @throws std::invalid_argument
double parse_number(const std::string& text);
std::vector<std::string> split(const std::string& text, char by);

/// Sets what the words ask for; returns the other words, file names.
/// @throws std::invalid_argument for unknown options and missing values
std::vector<std::string> parse_words(const std::vector<std::string>& words,
                                     const std::vector<Option>& options);

/// A whole program: `work` gets the files. Returns the exit code: 2 for wrong words, with the
/// usage; 1 if `work` returns false or throws. `files` is the usage's text for them; one is needed
/// unless it begins with "[".
int run_program(int argc, char** argv, const char* files, const std::vector<Option>& options,
                const std::function<bool(const std::vector<std::string>&)>& work);

/// @throws std::runtime_error
void write_file(const std::string& name, const std::string& content);

}  // namespace benchmarks
