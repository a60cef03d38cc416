// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/pdf_parts.h"

#include <cstdint>
#include <unordered_map>

namespace line_drawing {
namespace {

constexpr std::uint32_t clear = 256, end_of_data = 257, first_free = 258, last_code = 4094;

class Compression {
public:
    std::string of(const std::string& bytes) {
        begin();
        std::uint32_t known = clear;  // the code of what has been read since the last one written
        for (const char c : bytes) {
            const std::uint32_t byte = static_cast<unsigned char>(c), longer = known << 8 | byte;
            if (known == clear) {
                known = byte;
            } else if (const auto found = codes_.find(longer); found != codes_.end()) {
                known = found->second;
            } else {
                write(known);
                learn(longer);
                known = byte;
            }
        }
        if (known != clear) {
            write(known);
            grow();
        }
        write(end_of_data);
        if (bits_ > 0) result_ += char(pending_ << (8 - bits_));
        return result_;
    }

private:
    void begin() {
        write(clear);
        codes_.clear();
        last_ = first_free - 1;
        width_ = 9;
    }
    void learn(std::uint32_t sequence) {
        grow();
        if (last_ == last_code)
            begin();
        else
            codes_[sequence] = last_;
    }
    /// The reader gets one more code with each that it reads.
    void grow() {
        ++last_;
        if (last_ == 511 || last_ == 1023 || last_ == 2047) ++width_;
    }
    void write(std::uint32_t code) {
        pending_ = pending_ << width_ | code;
        for (bits_ += width_; bits_ >= 8; bits_ -= 8)
            result_ += char(pending_ >> (bits_ - 8));
        pending_ &= (1u << bits_) - 1;
    }

    std::string result_;
    std::unordered_map<std::uint32_t, std::uint32_t> codes_;
    std::uint32_t last_ = 0, pending_ = 0, width_ = 9, bits_ = 0;
};

}  // namespace

std::string compressed(const std::string& bytes) {
    return Compression().of(bytes);
}

}  // namespace line_drawing
