"""What ships the program to PCs without Python; see docs/packaging.md.

bundle
    Builds, tries and packs the folder by ``calrig.spec``.

Beside it: ``calrig.iss`` (Windows installer), ``calrig.desktop`` and ``70-calrig.rules`` (Linux).
"""
