// SPDX-License-Identifier: GPL-3.0-or-later
#include "runner.h"
#include <QApplication>
#include <QMainWindow>
#include <QProgressBar>
#include <QTimer>
#include "gui.h"
#include "times.h"

namespace driver {
namespace {

constexpr std::chrono::seconds default_limit(60);
constexpr int between_commands = 60;  // ms, so that MeshLab's own queued events run first
constexpr int between_retries = 50;
constexpr int between_actions = 5;  // thousands of them

QString describe(const Command& command) {
    return QString("line %1: %2 %3").arg(command.line).arg(command.name, command.rest).trimmed();
}

[[noreturn]] void endAt(const QString& where, const std::exception& why) {
    say(std::string("reason: ") + why.what());  // alone, for ./run to tell its user
    endWithError(where.toStdString() + ": " + why.what());
}

}  // namespace

Runner::Runner(QVector<Command> script, CommandTable table, QObject* parent)
    : QObject(parent),
      script_(std::move(script)),
      table_(std::move(table)),
      watchdog_(default_limit) {
    addOwnCommands();
    checkNames();
    watchdog_.watch("waiting for MeshLab's main window");
    scheduleStep(between_commands);
}

void Runner::addOwnCommands() {
    table_.add(
        "sleep", [this](const Command& c) { return sleep(c); }, Place::ModalBox);
    table_.addSimple("time-limit",
                     [this](const Command& c) {  // seconds, for each of the lines that follow
                         watchdog_.setLimit(std::chrono::milliseconds(qint64(1000 * c.number(0))));
                     });
    table_.addSimple("together", [this](const Command& c) { together(c); });
    table_.addSimple("time", [this](const Command& c) { time(c); });
    table_.addSimple("quit", [this](const Command&) {
        watchdog_.rest();  // looking for leaks takes as long as it takes
        endProcess(0);
    });
    table_.add(
        "random-actions", [this](const Command& c) { return randomActions(c); }, Place::Everywhere);
}

// Misspelt commands fail at once, not after minutes.
void Runner::checkNames() const {
    for (const Command& command : script_) {
        try {
            table_.find(command.name);
        } catch (const CommandError& e) {
            endAt(describe(command), e);
        }
    }
}

// A single shot: a repeating timer would not fire inside the event loop of a modal box that its own
// slot has opened.
void Runner::scheduleStep(int milliseconds) {
    QTimer::singleShot(milliseconds, this, &Runner::step);
}

void Runner::step() {
    QWidget* window = mainWindow();
    if (!window || !window->isVisible()) return scheduleStep(between_retries);
    if (next_ == 0)
        for (QProgressBar* bar : window->findChildren<QProgressBar*>())
            connect(bar, &QProgressBar::valueChanged, this, [this] { watchdog_.progress(); });
    if (next_ >= script_.size())
        return watchdog_.rest();  // no "quit" at the end: the user goes on by hand

    const Command command = script_[next_];
    try {
        const CommandTable::Entry& entry = table_.find(command.name);
        if (!mayStart(entry)) return scheduleStep(between_retries);
        watch(command);
        run(command, entry);
    } catch (const std::exception& e) {  // must not travel through Qt's event loop
        endAt(in_progress_.isEmpty() ? describe(command) : in_progress_.last(), e);
    }
}

bool Runner::mayStart(const CommandTable::Entry& entry) {
    QWidget* modal = QApplication::activeModalWidget();
    if (!modal)
        return in_progress_
            .isEmpty();  // otherwise a filter's progress call-back is running the event loop
    if (entry.place != Place::MainWindow) return true;
    if (acceptOptionsBox(modal)) return false;
    throw CommandError("MeshLab says: " + describeBox(modal));
}

void Runner::watch(const Command& command) {
    if (watched_line_ == command.line) return;  // a retry: its time goes on
    watched_line_ = command.line;
    say(describe(command).toStdString());
    watchdog_.watch(describe(command).toStdString());
}

void Runner::run(const Command& command, const CommandTable::Entry& entry) {
    const int position = next_++;
    const bool alone = entry.place == Place::Everywhere;
    // Before the command, which may block in a modal box.
    if (!alone) scheduleStep(between_commands);
    in_progress_ << describe(command);
    const Outcome outcome = entry.handler(command);
    in_progress_.removeLast();
    if (outcome == Outcome::Retry) next_ = position;
    if (alone) scheduleStep(between_actions);
}

Outcome Runner::sleep(const Command& command) {
    if (!sleeping_.isValid()) sleeping_.start();
    if (sleeping_.elapsed() < command.number(0)) return Outcome::Retry;
    sleeping_.invalidate();
    return Outcome::Done;
}

// COMMAND ; COMMAND...
void Runner::together(const Command& command) {
    for (const QString& text : command.rest.split(" ; ")) {
        const Command part = parseLine(text.trimmed());
        if (table_.find(part.name).handler(part) == Outcome::Retry)
            throw CommandError(part.name + " takes longer");
    }
}

// FILE COMMAND
void Runner::time(const Command& command) {
    const Command part = parseLine(command.rest.section(' ', 1).trimmed());
    appendTimes(command.word(0), [&] {
        if (table_.find(part.name).handler(part) == Outcome::Retry)
            throw CommandError(part.name + " takes longer");
    });
}

// SEED COUNT FILE...
Outcome Runner::randomActions(const Command& command) {
    if (!random_)
        random_ = std::make_unique<RandomActions>(
            unsigned(command.number(0)), int(command.number(1)), command.words.mid(2), table_,
            [this](const QString& line) {
                say(line.toStdString());
                watchdog_.watch("random action " + line.toStdString());
            });
    if (random_->step()) return Outcome::Retry;
    random_.reset();
    return Outcome::Done;
}

}  // namespace driver
