#!/usr/bin/env python3
"""Sum JUnit files into one line `N passed, N failed`; the status tells whether all passed.

sum_tests.py FAILED_STEPS FILE.xml ..     FAILED_STEPS: failures outside the files, as of a build
"""

import os
import sys
import xml.etree.ElementTree as ElementTree

passed, failed = 0, int(sys.argv[1])
for path in filter(os.path.isfile, sys.argv[2:]):
    for case in ElementTree.parse(path).iter("testcase"):
        broken = case.get("status") == "notrun"  # ctest: the program is missing
        if broken or case.find("failure") is not None or case.find("error") is not None:
            failed += 1
            print("failed:", case.get("classname"), case.get("name"))
        elif case.find("skipped") is None:
            passed += 1
print(f"{passed} passed, {failed} failed")
sys.exit(0 if passed and not failed else 1)
