#!/usr/bin/env -S python3 -B
"""The report on whether a box can be trusted names what is missing and what is out of its bounds."""

import trust_report

GOOD = {"fat_images": 10_000, "fat_images_hung": 0, "usb_liars": 21, "usb_liars_let_in": 0, "hung_input_back_s": 1.0,
        "hung_lips_back_s": 2.3}


def faults(wait_ms=40.0, **changed):
    return list(trust_report.faults(trust_report.figures(GOOD | changed, wait_ms)))


def main():
    assert faults() == [], faults()
    assert trust_report.figures(GOOD, 1.0)["hung_program_back_s"] == 2.3
    for wrong in ({"fat_images": 9999}, {"fat_images_hung": 1}, {"usb_liars_let_in": 1}, {"hung_lips_back_s": 3.1}):
        assert len(faults(**wrong)) == 1, wrong
    slow = trust_report.figures(GOOD | {"hung_lips_back_s": 2.5}, 1.0)
    assert list(trust_report.faults(slow)) == [], "an emulated machine reaches no more"
    assert list(trust_report.bounded_report.short_of_goals(slow, trust_report.GOALS)) == ["hung_program_back_s is 2.5: its goal of 2 is not reached"]
    assert faults(wait_ms=None) == ["silent_clients_wait_ms was not measured"]
    without_lips = {name: value for name, value in GOOD.items() if name != "hung_lips_back_s"}
    found = trust_report.figures(without_lips, 1.0)
    assert list(trust_report.faults(found)) == ["hung_program_back_s was not measured"]


if __name__ == "__main__":
    main()
