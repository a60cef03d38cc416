// SPDX-License-Identifier: GPL-3.0-or-later
#include "runner.h"
#include <QApplication>
#include <QTimer>
#include "gui.h"
#include "report.h"

namespace driver {
namespace {

constexpr std::chrono::seconds defaultLimit(60);
constexpr int betweenCommands = 60;  // ms, so that MeshLab's own queued events run first
constexpr int betweenRetries = 50;
constexpr int betweenActions = 5;  // thousands of them

QString describe(const Command& command) {
    return QString("line %1: %2 %3").arg(command.line).arg(command.name, command.rest).trimmed();
}

[[noreturn]] void endAt(const QString& where, const std::exception& why) {
    endWithError(where.toStdString() + ": " + why.what());
}

}  // namespace

Runner::Runner(QVector<Command> script, CommandTable table, QObject* parent)
    : QObject(parent),
      m_script(std::move(script)),
      m_table(std::move(table)),
      m_watchdog(defaultLimit) {
    addOwnCommands();
    checkNames();
    m_watchdog.watch("waiting for MeshLab's main window");
    scheduleStep(betweenCommands);
}

void Runner::addOwnCommands() {
    m_table.add(
        "sleep", [this](const Command& c) { return sleep(c); }, Place::ModalBox);
    m_table.addSimple(
        "time-limit", [this](const Command& c) {  // seconds, for each of the lines that follow
            m_watchdog.setLimit(std::chrono::milliseconds(qint64(1000 * c.number(0))));
        });
    m_table.addSimple("together", [this](const Command& c) { together(c); });
    m_table.addSimple("quit", [this](const Command&) {
        m_watchdog.rest();  // looking for leaks takes as long as it takes
        endProcess(0);
    });
    m_table.add(
        "random-actions", [this](const Command& c) { return randomActions(c); }, Place::Everywhere);
}

// A misspelt command fails at once, not after minutes.
void Runner::checkNames() const {
    for (const Command& command : m_script) {
        try {
            m_table.find(command.name);
        } catch (const CommandError& e) {
            endAt(describe(command), e);
        }
    }
}

// Always a fresh single shot: a repeating timer does not fire again inside the event loop of a
// modal box that its own slot has opened, so it could never answer that box.
void Runner::scheduleStep(int milliseconds) {
    QTimer::singleShot(milliseconds, this, &Runner::step);
}

void Runner::step() {
    QWidget* window = mainWindow();
    if (!window || !window->isVisible()) return scheduleStep(betweenRetries);
    if (m_next >= m_script.size())
        return m_watchdog.rest();  // no "quit" at the end: the user goes on by hand

    const Command command = m_script[m_next];
    try {
        const CommandTable::Entry& entry = m_table.find(command.name);
        if (!mayStart(entry)) return scheduleStep(betweenRetries);
        watch(command);
        run(command, entry);
    } catch (const std::exception& e) {  // must not travel through Qt's event loop
        endAt(m_inProgress.isEmpty() ? describe(command) : m_inProgress.last(), e);
    }
}

bool Runner::mayStart(const CommandTable::Entry& entry) {
    QWidget* modal = QApplication::activeModalWidget();
    if (!modal)
        return m_inProgress
            .isEmpty();  // otherwise a filter's progress call-back is running the event loop
    if (entry.place != Place::MainWindow) return true;
    if (acceptOptionsBox(modal)) return false;
    throw CommandError("MeshLab says: " + describeBox(modal));
}

void Runner::watch(const Command& command) {
    if (m_watchedLine == command.line) return;  // a retry: its time goes on
    m_watchedLine = command.line;
    say(describe(command).toStdString());
    m_watchdog.watch(describe(command).toStdString());
}

void Runner::run(const Command& command, const CommandTable::Entry& entry) {
    const int position = m_next++;
    const bool alone = entry.place == Place::Everywhere;
    // before the command, which may block in a modal box
    if (!alone) scheduleStep(betweenCommands);
    m_inProgress << describe(command);
    const Outcome outcome = entry.handler(command);
    m_inProgress.removeLast();
    if (outcome == Outcome::Retry) m_next = position;
    if (alone) scheduleStep(betweenActions);
}

Outcome Runner::sleep(const Command& command) {
    if (!m_sleeping.isValid()) m_sleeping.start();
    if (m_sleeping.elapsed() < command.number(0)) return Outcome::Retry;
    m_sleeping.invalidate();
    return Outcome::Done;
}

// COMMAND ; COMMAND...
void Runner::together(const Command& command) {
    for (const QString& text : command.rest.split(" ; ")) {
        const Command part = parseLine(text.trimmed());
        if (m_table.find(part.name).handler(part) == Outcome::Retry)
            throw CommandError(part.name + " takes longer");
    }
}

// SEED COUNT FILE...
Outcome Runner::randomActions(const Command& command) {
    if (!m_random)
        m_random = std::make_unique<RandomActions>(
            unsigned(command.number(0)), int(command.number(1)), command.words.mid(2), m_table,
            [this](const QString& line) {
                say(line.toStdString());
                m_watchdog.watch("random action " + line.toStdString());
            });
    if (m_random->step()) return Outcome::Retry;
    m_random.reset();
    return Outcome::Done;
}

}  // namespace driver
