// SPDX-License-Identifier: GPL-3.0-or-later
#include "pixels/canvas.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace line_drawing {
namespace {

constexpr int end_of_block = 256, first_length = 257, symbol_count = 286, longest_code = 15;
constexpr int shortest_run = 3, longest_run = 258;  // behind the byte that it repeats

/// A byte, or a number of repeats of the one before.
struct Symbol {
    int number;
    int extra = 0, extra_bits = 0;  ///< the rest of a length
};

Symbol symbolOfRun(int length) {
    if (length == longest_run) return {symbol_count - 1};
    int bits = 0;  // lengths go up by four symbols with as many extra bits
    while (length - shortest_run >= 8 << bits)
        ++bits;
    const int rest = length - shortest_run;
    return {first_length + 4 * bits + (rest >> bits), rest & ((1 << bits) - 1), bits};
}

template <class Take>
void eachSymbol(const std::uint8_t* row, int width, Take take) {
    take(Symbol{0});
    for (int x = 0; x < width;) {
        const int begin = x++;
        take(Symbol{row[begin]});
        while (x < width && row[x] == row[begin])
            ++x;
        int rest = x - begin - 1;
        for (; rest >= shortest_run; rest -= std::min(rest, longest_run))
            take(symbolOfRun(std::min(rest, longest_run)));
        for (; rest > 0; --rest)
            take(Symbol{row[begin]});
    }
}

using Counts = std::array<std::uint64_t, symbol_count>;
using Lengths = std::array<int, symbol_count>;

/// Huffman's code; 0 for symbols that do not occur.
Lengths codeLengths(const Counts& counts) {
    struct Node {
        std::uint64_t count;
        int number;
        bool operator>(const Node& other) const {
            return count != other.count ? count > other.count : number > other.number;
        }
    };
    std::priority_queue<Node, std::vector<Node>, std::greater<>> nodes;
    std::vector<int> parents(2 * std::size_t(symbol_count));
    for (int symbol = 0; symbol < symbol_count; ++symbol)
        if (counts[std::size_t(symbol)] > 0) nodes.push({counts[std::size_t(symbol)], symbol});
    int next = symbol_count;
    for (; nodes.size() > 1; ++next) {
        std::uint64_t sum = 0;
        for (int child = 0; child < 2; ++child) {
            sum += nodes.top().count;
            parents[std::size_t(nodes.top().number)] = next;
            nodes.pop();
        }
        nodes.push({sum, next});
    }
    Lengths lengths = {};
    for (std::size_t symbol = 0; symbol < symbol_count; ++symbol)
        for (int node = parents[symbol]; node != 0; node = parents[std::size_t(node)])
            ++lengths[symbol];
    return lengths;
}

/// Rarer symbols count as more frequent until no code is too long.
Lengths shortCodeLengths(Counts counts) {
    Lengths lengths = codeLengths(counts);
    while (*std::max_element(lengths.begin(), lengths.end()) > longest_code) {
        for (std::uint64_t& count : counts)
            count = (count + 1) / 2;
        lengths = codeLengths(counts);
    }
    return lengths;
}

class Deflation {
public:
    std::string of(const Canvas& canvas) {
        const auto each_symbol = [&](auto take) {
            for (int y = 0; y < canvas.height(); ++y)
                eachSymbol(canvas.row(y), canvas.width(), take);
        };
        Counts counts = {};
        counts[end_of_block] = 1;
        each_symbol([&](const Symbol& symbol) { ++counts[std::size_t(symbol.number)]; });
        lengths_ = shortCodeLengths(counts);
        beginBlock();
        makeCodes();
        each_symbol([&](const Symbol& symbol) { write(symbol); });
        write({end_of_block});
        write(0, 7);  // to the end of the last byte
        return std::move(bytes_);
    }

private:
    /// One last block with codes of its own. Lengths are in codes of four bits, the number itself.
    void beginBlock() {
        write(1, 1);
        write(2, 2);
        write(symbol_count - 257, 5);
        write(0, 5);  // one distance: the byte before
        write(19 - 4, 4);
        for (const int length : {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15})
            write(length < 16 ? 4 : 0, 3);
        for (const int length : lengths_)
            writeCode(length, 4);
        writeCode(1, 4);
    }

    void makeCodes() {
        int code = 0;
        for (int length = 1; length <= longest_code; ++length, code <<= 1)
            for (std::size_t symbol = 0; symbol < symbol_count; ++symbol)
                if (lengths_[symbol] == length) codes_[symbol] = code++;
    }

    void write(const Symbol& symbol) {
        writeCode(codes_[std::size_t(symbol.number)], lengths_[std::size_t(symbol.number)]);
        if (symbol.number <= end_of_block) return;
        write(symbol.extra, symbol.extra_bits);
        write(0, 1);  // the distance
    }
    /// Highest bit first.
    void writeCode(int code, int bits) {
        while (bits-- > 0)
            write(code >> bits & 1, 1);
    }
    void write(int value, int bits) {
        pending_ |= unsigned(value) << bits_;
        for (bits_ += bits; bits_ >= 8; bits_ -= 8, pending_ >>= 8)
            bytes_ += char(pending_ & 255);
    }

    Lengths lengths_ = {}, codes_ = {};
    std::string bytes_;
    unsigned pending_ = 0;
    int bits_ = 0;
};

/// Adler-32.
std::uint64_t checksumOf(const Canvas& canvas) {
    constexpr std::uint64_t base = 65521;
    std::uint64_t sum = 1, sums = 0;
    for (int y = 0; y < canvas.height(); ++y) {
        sums += sum;  // of the byte that the row begins with
        for (int x = 0; x < canvas.width(); ++x)
            sums += sum += canvas.row(y)[x];
        sum %= base;
        sums %= base;
    }
    return sums << 16 | sum;
}

}  // namespace

std::string deflatedRows(const Canvas& canvas) {
    const std::uint64_t checksum = checksumOf(canvas);
    std::string stream = "\x78\xda" + Deflation().of(canvas);
    for (int shift = 24; shift >= 0; shift -= 8)
        stream += char(checksum >> shift & 255);
    return stream;
}

}  // namespace line_drawing
