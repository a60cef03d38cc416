# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab by the year in its version, and the release of Debian that packages it."""

SUITES = {"2020": "bookworm", "2022": "trixie", "2025": "forky"}
