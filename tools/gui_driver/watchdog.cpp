// SPDX-License-Identifier: GPL-3.0-or-later
#include "watchdog.h"
#include "report.h"

namespace driver {

Watchdog::Watchdog(std::chrono::milliseconds limit) : m_limit(limit), m_thread([this] { run(); }) {}

Watchdog::~Watchdog() {
    {
        std::lock_guard<std::mutex> lock(m_mutex);
        m_ending = true;
    }
    m_changed.notify_one();
    m_thread.join();
}

void Watchdog::setLimit(std::chrono::milliseconds limit) {
    std::lock_guard<std::mutex> lock(m_mutex);
    m_limit = limit;
}

void Watchdog::watch(const std::string& what) {
    {
        std::lock_guard<std::mutex> lock(m_mutex);
        m_what = what;
        m_spent = {};
        m_watching = true;
    }
    m_changed.notify_one();
}

void Watchdog::rest() {
    std::lock_guard<std::mutex> lock(m_mutex);
    m_watching = false;
}

void Watchdog::run() {
    constexpr std::chrono::milliseconds look(50);
    std::unique_lock<std::mutex> lock(m_mutex);
    while (!m_ending) {
        if (!m_watching) {
            m_changed.wait(lock);
        } else if (m_changed.wait_for(lock, look) == std::cv_status::timeout && m_watching) {
            m_spent += look;  // however long it took until this thread could look
            if (m_spent >= m_limit)
                endWithError(m_what + ": time-out after " +
                             std::to_string(m_limit.count() / 1000.) + " s");
        }
    }
}

}  // namespace driver
