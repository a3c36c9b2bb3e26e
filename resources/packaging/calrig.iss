; Installer for Windows, made of the folder that `python bootstrap.py bundle` leaves in dist\calrig:
;     iscc /DVersion=0.1.0 resources\packaging\calrig.iss
#ifndef Version
  #error State the version: iscc /DVersion=0.1.0 calrig.iss
#endif

[Setup]
AppId={{6B3B1E0C-7E0B-4F0E-9C58-6D0B0C5B7A11}
AppName=CalRig
AppVersion={#Version}
DefaultDirName={autopf}\CalRig
DefaultGroupName=CalRig
; Laboratory accounts seldom have administrators' rights; serial ports need none.
PrivilegesRequired=lowest
PrivilegesRequiredOverridesAllowed=dialog
ArchitecturesInstallIn64BitMode=x64compatible
ArchitecturesAllowed=x64compatible
LicenseFile=..\..\LICENSE
SourceDir=..\..
OutputDir=dist
OutputBaseFilename=calrig-{#Version}-setup
Compression=lzma2
SolidCompression=yes

[Files]
Source: "dist\calrig\*"; DestDir: "{app}"; Flags: recursesubdirs ignoreversion

[Icons]
Name: "{group}\CalRig"; Filename: "{app}\calrig.exe"
Name: "{group}\CalRig on the simulated rig"; Filename: "{app}\calrig.exe"; Parameters: "--simulated"
Name: "{autodesktop}\CalRig"; Filename: "{app}\calrig.exe"; Tasks: desktop

[Tasks]
Name: desktop; Description: "A shortcut on the desktop"

[Run]
Filename: "{app}\calrig.exe"; Description: "Start CalRig"; Flags: nowait postinstall skipifsilent
