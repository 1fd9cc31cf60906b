#!/usr/bin/env python3
"""Sum JUnit files into one line `N passed, N failed, N skipped`; the status tells whether all passed.

sum_tests.py FAILED_STEPS FILE.xml ..     FAILED_STEPS: failures outside the files, as of a build
"""

import os
import sys
import xml.etree.ElementTree as ElementTree

passed, failed, skipped = 0, int(sys.argv[1]), 0
for path in filter(os.path.isfile, sys.argv[2:]):
    for case in ElementTree.parse(path).iter("testcase"):
        skip = case.find("skipped")
        # ctest says `notrun` of a program that is missing and of one that asks to be skipped
        asked = skip is not None and "SKIP_RETURN_CODE" in skip.get("message", "")
        broken = case.get("status") == "notrun" and not asked
        if broken or case.find("failure") is not None or case.find("error") is not None:
            failed += 1
            print("failed:", case.get("classname"), case.get("name"))
        elif skip is None:
            passed += 1
        else:
            skipped += 1
print(f"{passed} passed, {failed} failed, {skipped} skipped")
sys.exit(0 if passed and not failed else 1)
