"""The devices at the ports: who they are, and the links to them.

================  ==================================================================
setup             `DeviceSetup`: where a device is and what it speaks
connection        `Connection`: the links of all devices, drained by one timer
link              `Link`: one reader with its raw log and its state in words
words             what the banner says of a silent or broken link
stopping          Stop Device, Start Device
adc, adc_view     View ADC Data: live codes of all channels with mean and STD
presenter         Device Properties: ports, scan, identification
state             what its panel shows
scan_words        what a scan brought, in words
view              its panel below the device strip
================  ==================================================================
"""
