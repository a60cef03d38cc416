// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_actions.h"

#include "process.h"

namespace driver {

// The first redraws of a project's window may show nothing.
constexpr int most_checks = 100;

// A line that fails this often tests nothing.
constexpr int enough_tries = 6;

RandomActions::RandomActions(unsigned seed, int count, const QStringList& meshes,
                             const CommandTable& table, Announce announce)
    : actions_(seed, meshes),
      table_(table),
      announce_(std::move(announce)),
      left_(count),
      checks_left_(most_checks) {
    if (meshes.isEmpty()) throw CommandError("say which meshes to open");
}

bool RandomActions::step() {
    if (!pending_.isEmpty()) {
        run(pending_.takeFirst());
        if (pending_.isEmpty()) checks_left_ = most_checks;
    }
    if (checks_left_ > 0) check();
    if (checks_left_ > 0 || !pending_.isEmpty()) return true;
    if (left_ == 0) {
        conclude();
        return false;
    }
    --left_;
    pending_ = actions_.next(now_);
    return true;
}

// MeshLab may have disabled an action or lack a field: that ends an action, as it ends a user's.
void RandomActions::run(const QString& line) {
    ++lines_;
    ++tries_[line].all;
    announce_(line);
    const Command command = parseLine(line);
    try {
        if (table_.find(command.name).handler(command) == Outcome::Retry) pending_.prepend(line);
    } catch (const CommandError& why) {
        say(std::string("# not possible: ") + why.what());
        ++impossible_;
        ++tries_[line].failed;
        pending_.clear();
    }
}

void RandomActions::check() {
    for (const QString& text : boxes_.takeTexts())
        say("# box: " + text.toStdString());
    watch_.takeDrawn();
    for (QGLWidget* view : visibleViews())
        view->repaint();
    const std::map<int, QString> drawn = watch_.takeDrawn();
    const QStringList problems = watch_.takeProblems();
    if (!problems.isEmpty()) throw CommandError(problems.join("; "));
    now_ = presentSituation();
    const QString missing = whatIsMissing(drawn);
    if (missing.isEmpty())
        checks_left_ = 0;
    else if (--checks_left_ == 0)
        throw CommandError(missing);
}

QString RandomActions::whatIsMissing(const std::map<int, QString>& drawn) const {
    if (now_.has_lines && now_.current->isVisible() && !drawn.count(int(now_.current->id())))
        return "the decoration is on, but nothing is drawn";
    for (const auto& [mesh, refusal] : drawn)
        if (!refusal.isEmpty() && !logText().contains(refusal))
            return "the log does not say why there are no lines: " + refusal + "\nit says:\n" +
                   logText();
    return {};
}

void RandomActions::conclude() const {
    say(QString("%1 lines, %2 of them not possible; %3")
            .arg(lines_)
            .arg(impossible_)
            .arg(watch_.summary())
            .toStdString());
    if (watch_.comparisons() == 0) throw CommandError("no lines were ever drawn");
    for (const auto& [line, tries] : tries_)
        if (tries.all >= enough_tries && tries.failed == tries.all)
            throw CommandError(line + " was never possible");
}

}  // namespace driver
