// SPDX-License-Identifier: GPL-3.0-or-later
#include "left_out.h"

#include <QFile>
#include <QStringList>
#include <stdexcept>

namespace benchmarks {

LeftOut::LeftOut(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text))
        throw std::runtime_error(name.toStdString() + " cannot be opened");
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine()).trimmed();
        if (line.isEmpty() || line.startsWith('#')) continue;
        const QStringList words = line.split('\t');
        if (words.size() != 3 || words[2].isEmpty())
            throw std::runtime_error(
                name.toStdString() +
                " needs part, direction and reason, not: " + line.toStdString());
        entries_.insert({words[0].toStdString(), words[1].toStdString()});
    }
}

}  // namespace benchmarks
