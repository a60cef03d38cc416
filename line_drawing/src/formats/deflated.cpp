// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <array>
#include <memory>
#include <new>

#include "formats/sheet_writers.h"

namespace line_drawing {

std::string deflated(std::string_view bytes) {
    z_stream stream = {};
    if (deflateInit(&stream, Z_DEFAULT_COMPRESSION) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
    stream.next_in = reinterpret_cast<z_const Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    std::string result;
    std::array<char, 1 << 16> part;
    for (int state = Z_OK; state == Z_OK;) {
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = uInt(part.size());
        state = deflate(&stream, Z_FINISH);
        result.append(part.data(), part.size() - stream.avail_out);
    }
    return result;
}

}  // namespace line_drawing
