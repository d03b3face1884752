#!/usr/bin/env -S python3 -B
"""The report on the control surfaces names what is missing and what is out of its bounds."""

import firmware_report as report

GOOD = {name: least for name, (least, _) in report.BOUNDS.items()}


def faults(**changed):
    return list(report.faults(report.figures(GOOD | changed)))


def main():
    assert faults() == [], faults()
    for wrong in ({"flash_bytes": 50_000}, {"heap_bytes": 4}, {"counts_lost": 1}, {"button_us": 2501}, {"emulated_is_shipped": 0},
                  {"controls_passed": 1}, {"serial_false_values_after_gap": 1}, {"twins_played": 13}, {"surfaces_played": 10},
                  {"usb_fuzz_execs": 10}, {"gpio_edges": 999}, {"chip_plays_box": 0}, {"chip_plays_pod": 0},
                  {"report_latency_edges": 9999}, {"button_presses": 999}):
        assert len(faults(**wrong)) == 1, wrong
    assert faults(edges_tested=None) == ["edges_tested was not measured"]
    assert faults(surfaces_played=None) == []
    assert report.missing(report.figures(GOOD | {"surfaces_played": None})) == ["surfaces_played was not measured; ./box test --bench does"]
    assert report.proved(["edges_tested 5", "counts_lost 0", "edges_tested 7"]) == {"edges_tested": 12, "counts_lost": 0}
    assert report.largest({"a": {"ram_bytes": 3}, "b": {"ram_bytes": 8, "heap_bytes": 0}}) == {"ram_bytes": 8, "heap_bytes": 0}
    assert report.fuzzed("stat::number_of_executed_units: 12\n") == {"usb_fuzz_execs": 12} and report.fuzzed("") == {}
    cases = [{"name": "a", "twin": "knob"}, {"name": "b", "twin": "knob"}, {"name": "c"}]
    assert report.twins(cases, True) == {"twins_played": 1} and report.twins(cases, False) == {}


if __name__ == "__main__":
    main()
