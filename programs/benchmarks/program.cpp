// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace benchmarks {
namespace {

std::string key_of(const Option& option) {
    return split(option.name, ' ').front();
}

double number_within(const Option& option, const std::string& text, double least, double most) {
    const double value = parse_number(text);
    if (value >= least && value <= most) return value;
    throw std::invalid_argument(key_of(option) + " needs a number, at least " +
                                std::to_string(int(least)));
}

Option with_setter(Option option, std::function<void(const Option&, const std::string&)> set) {
    const Option named = option;
    option.set = [named, set](const std::string& text) { set(named, text); };
    return option;
}

void print_usage(const std::string& program, const std::string& files,
                 const std::vector<Option>& options) {
    std::fprintf(stderr, "%s [OPTIONS] %s\n", program.c_str(), files.c_str());
    for (const Option& option : options)
        std::fprintf(stderr, "  %-28s %s\n", option.name.c_str(), option.help.c_str());
}

}  // namespace

std::vector<std::string> split(const std::string& text, char by) {
    std::vector<std::string> parts = {""};
    for (const char c : text)
        if (c == by)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

double parse_number(const std::string& text) {
    std::size_t read = 0;
    double value = NAN;
    try {
        value = std::stod(text, &read);
    } catch (const std::exception&) {
    }
    if (read != text.size() || !std::isfinite(value))
        throw std::invalid_argument("'" + text + "' is no number");
    return value;
}

Option flag(const std::string& name, const std::string& help, bool& value) {
    return {name, help, [&value](const std::string&) { value = true; }};
}

Option text(const std::string& name, const std::string& help, std::string& value) {
    return {name, help, [&value](const std::string& text) { value = text; }};
}

Option number(const std::string& name, const std::string& help, double& value, double least,
              double most) {
    return with_setter({name, help, {}}, [=, &value](const Option& o, const std::string& text) {
        value = number_within(o, text, least, most);
    });
}

Option number(const std::string& name, const std::string& help, int& value, double least) {
    return with_setter({name, help, {}}, [=, &value](const Option& o, const std::string& text) {
        value = int(number_within(o, text, least, 1e9));
    });
}

Option numbers(const std::string& name, const std::string& help, std::vector<double>& values) {
    return with_setter({name, help, {}}, [&values](const Option& o, const std::string& text) {
        values.clear();
        for (const std::string& part : split(text, ','))
            values.push_back(number_within(o, part, 0, 1e300));
    });
}

std::vector<std::string> parse_words(const std::vector<std::string>& words,
                                     const std::vector<Option>& options) {
    std::vector<std::string> files;
    for (auto word = words.begin(); word != words.end(); ++word) {
        if (word->empty() || word->front() != '-') {
            files.push_back(*word);
            continue;
        }
        const auto option = std::find_if(options.begin(), options.end(),
                                         [&](const Option& o) { return key_of(o) == *word; });
        if (option == options.end()) throw std::invalid_argument("unknown option " + *word);
        const bool has_value = option->name != *word;
        if (has_value && ++word == words.end())
            throw std::invalid_argument(key_of(*option) + " needs a value");
        option->set(has_value ? *word : "");
    }
    return files;
}

int run_program(int argc, char** argv, const char* files, const std::vector<Option>& options,
                const std::function<bool(const std::vector<std::string>&)>& work) {
    const std::string program = split(argv[0], '/').back();
    const auto tell = [&](const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", program.c_str(), error.what());
    };
    try {
        const std::vector<std::string> named = parse_words({argv + 1, argv + argc}, options);
        if (named.empty() && files[0] != '[') throw std::invalid_argument("no file is named");
        return work(named) ? 0 : 1;
    } catch (const std::invalid_argument& error) {
        tell(error);
        print_usage(program, files, options);
        return 2;
    } catch (const std::exception& error) {
        tell(error);
        return 1;
    }
}

void write_file(const std::string& name, const std::string& content) {
    if (!(std::ofstream(name, std::ios::binary) << content << std::flush))
        throw std::runtime_error("cannot write " + name);
}

}  // namespace benchmarks
