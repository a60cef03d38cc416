// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_names.h"

#include <langinfo.h>
#include <QTextCodec>
#include <clocale>
#include <cstring>

namespace {

constexpr ushort first_odd = 0xDC80, last_odd = 0xDCFF;
constexpr int utf8_mib = 106, own_mib = -106;

bool isOdd(QChar c) {
    return c.unicode() >= first_odd && c.unicode() <= last_odd;
}

/// Calls `take(place, length)` for each odd byte, length 1, and for the runs between.
template <class Take>
void cutAtOddBytes(const QChar* text, int length, Take take) {
    int begin = 0;
    for (int i = 0; i < length; ++i) {
        if (text[i].isHighSurrogate() && i + 1 < length && text[i + 1].isLowSurrogate()) {
            ++i;
        } else if (isOdd(text[i])) {
            take(begin, i - begin);
            take(i, 1);
            begin = i + 1;
        }
    }
    take(begin, length - begin);
}

int lengthByFirst(uchar byte) {
    if (byte < 0x80) return 1;
    return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
}

class FileNameCodec : public QTextCodec {
public:
    QByteArray name() const override { return "laplacian-lines-file-names"; }
    int mibEnum() const override { return own_mib; }

protected:
    QString convertToUnicode(const char* in, int length, ConverterState*) const override {
        QString result;
        for (int i = 0; i < length;) {
            const int bytes = lengthByFirst(uchar(in[i]));
            ConverterState state(IgnoreHeader);  // else a mark of the byte order is left out
            const QString character =
                i + bytes <= length ? utf8_.toUnicode(in + i, bytes, &state) : QString();
            const bool is_one =
                !character.isEmpty() && state.invalidChars == 0 && state.remainingChars == 0;
            result += is_one ? character : QString(QChar(0xDC00 + uchar(in[i])));
            i += is_one ? bytes : 1;
        }
        return result;
    }

    QByteArray convertFromUnicode(const QChar* in, int length, ConverterState*) const override {
        QByteArray result;
        cutAtOddBytes(in, length, [&](int place, int count) {
            if (count == 1 && isOdd(in[place]))
                result += char(in[place].unicode() & 0xFF);
            else
                result += QString(in + place, count).toUtf8();
        });
        return result;
    }

private:
    const QTextCodec& utf8_ = *codecForMib(utf8_mib);
};

}  // namespace

void keepFileNames() {
    std::setlocale(LC_CTYPE, "");
    const char* characters = nl_langinfo(CODESET);
    const bool is_utf8 = std::strcmp(characters, "UTF-8") == 0;
    if (is_utf8 || std::strcmp(characters, "ANSI_X3.4-1968") == 0)
        QTextCodec::setCodecForLocale(new FileNameCodec);  // Qt's own from then on
}

QString readable(const QString& name) {
    QString result;
    cutAtOddBytes(name.constData(), name.size(), [&](int place, int count) {
        const bool is_odd = count == 1 && isOdd(name[place]);
        result += is_odd ? QString(QChar::ReplacementCharacter) : name.mid(place, count);
    });
    return result;
}
