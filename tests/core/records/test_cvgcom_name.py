from core.records.cvgcom_name import CvgcomName, folder_of, next_name


def test_names_of_the_old_program():
    name = CvgcomName.parse("25-143.exp(001)_d_pr1.txt")
    assert name == CvgcomName("25-143", 1, False, 1)
    assert name.stem == "25-143.exp(001)_d_pr1"
    assert CvgcomName.parse("RotationTable_202405131405.txt") is None


def test_the_next_number_is_free_in_every_kind_and_suffix(tmp_path):
    folder = folder_of(tmp_path, "25-143")
    assert folder == tmp_path / ".Gyro_Data" / "25-143"
    assert next_name(folder, "25-143", static=True, profile=1).experiment == 1
    folder.mkdir(parents=True)
    for stem in ("25-143.exp(003)_d_pr2.txt", "25-143.exp(004)_s_pr1.calrec", "notes.txt"):
        (folder / stem).touch()
    name = next_name(folder, "25-143", static=False, profile=2)
    assert name.stem == "25-143.exp(005)_d_pr2"


def test_no_device_name_leaves_its_folder(tmp_path):
    assert folder_of(tmp_path, "../..").parent == tmp_path / ".Gyro_Data"
