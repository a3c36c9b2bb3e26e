"""The devices at the ports: who they are, and the links to them.

================  ==================================================================
setup             `DeviceSetup`: where a device is and what it speaks
connection        `Connection`: the links of all devices, drained by one timer
link              `Link`: one reader with its raw log and its state in words
words             what the banner says of a silent or broken link
presenter         Device Properties: ports, scan, identification
state             what its panel shows
scan_words        what a scan brought, in words
view              its panel below the device strip
================  ==================================================================
"""
