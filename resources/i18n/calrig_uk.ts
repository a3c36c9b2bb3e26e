<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="uk" sourcelanguage="en">
    <context>
        <name>AccuracyForm</name>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Angles</source>
            <translation>Кути</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>u(head angle), arcsec</source>
            <translation>u(кута головки), arcsec</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Limit ±, deg (0: none)</source>
            <translation>Межа ±, deg (0: немає)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Decision rule</source>
            <translation>Правило рішення</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Own angles by the calibration</source>
            <translation>Власні кути за калібруванням</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Calibration</source>
            <translation>Калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Calibrations and positions (*.cal.json *.txt *.run.csv session.json)</source>
            <translation>Калібрування і положення (*.cal.json *.txt *.run.csv session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>a file...</source>
            <translation>файл…</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Pitch</source>
            <translation>Тангаж</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Roll</source>
            <translation>Крен</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Pitch or roll to set, e.g. 0, 30, 60; Enter takes it</source>
            <translation>Тангаж або крен для задання, напр. 0, 30, 60; Enter приймає</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>with uncertainty: guard band U</source>
            <translation>захисна смуга U</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>simple acceptance</source>
            <translation>просте прийняття</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>nearest of this unit</source>
            <translation>найближче</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>none</source>
            <translation>немає</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Choose</source>
            <translation>Вибрати</translation>
        </message>
    </context>
    <context>
        <name>AccuracyResultsView</name>
        <message>
            <location filename="../../gui/accuracy/results_view.py" />
            <source>Pages of the graph</source>
            <translation>Сторінки графіка</translation>
        </message>
    </context>
    <context>
        <name>ActionBar</name>
        <message>
            <location filename="../../gui/widgets/action_bar.py" />
            <source>Hands-free</source>
            <translation>Без рук</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/action_bar.py" />
            <source>Recognises rest in the next position and accumulates by itself ({key})</source>
            <translation>Розпізнає спокій у наступному положенні й накопичує сам ({key})</translation>
        </message>
    </context>
    <context>
        <name>AdcPanel</name>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>{count} samples since Clear</source>
            <translation>відліків після очищення: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>calibrated by {name}</source>
            <translation>калібровано за {name}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>Clear</source>
            <translation>Очистити</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>Begin mean, STD, Min and Max anew</source>
            <translation>Почати середнє, СКВ, мін. і макс. знову</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>Copy</source>
            <translation>Копіювати</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>ADC data of all channels</source>
            <translation>Дані АЦП усіх каналів</translation>
        </message>
    </context>
    <context>
        <name>AdvisorSide</name>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Sensor</source>
            <translation>Датчик</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Rig</source>
            <translation>Стенд</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Accelerometer</source>
            <translation>Акселерометр</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Gyro</source>
            <translation>Гіроскоп</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Dividing head</source>
            <translation>Ділильна головка</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Rate table</source>
            <translation>Поворотний стенд</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Climate chamber</source>
            <translation>Термокамера</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Level base</source>
            <translation>Горизонтальна основа</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Kind</source>
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Axis</source>
            <translation>Вісь</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Case axis along which it looks.</source>
            <translation>Вісь корпусу, вздовж якої він дивиться.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Accumulate</source>
            <translation>Накопичення</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>At each position; 0 takes the time of the plan.</source>
            <translation>У кожному положенні; 0 бере час із плану.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Turning</source>
            <translation>Поворот</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Time that a change of the position takes.</source>
            <translation>Час, потрібний на зміну положення.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Local g</source>
            <translation>Місцеве g</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>u(g)</source>
            <translation>u(g)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Standard uncertainty, k = 1.</source>
            <translation>Стандартна невизначеність, k = 1.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>u(head)</source>
            <translation>u(головки)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Of one setting of the dividing head.</source>
            <translation>Одного встановлення ділильної головки.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>u(table)</source>
            <translation>u(стенда)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Of one setting of the rate table.</source>
            <translation>Одного встановлення поворотного стенда.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>North positive, south negative.</source>
            <translation>Північна додатна, південна від'ємна.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>as the plan</source>
            <translation>за планом</translation>
        </message>
    </context>
    <context>
        <name>AllanView</name>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Add Records</source>
            <translation>Додати записи</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Records (*.calrec *.txt *.csv *.dat)</source>
            <translation>Записи (*.calrec *.txt *.csv *.dat)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Confidence</source>
            <translation>Довірча смуга</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Bands of one sigma, from the equivalent degrees of freedom</source>
            <translation>Смуги однієї сигми за еквівалентними ступенями вільності</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Fitted terms</source>
            <translation>Оцінені складові</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Terms of the chosen record with their slopes</source>
            <translation>Складові вибраного запису з їх нахилами</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Records</source>
            <translation>Записи</translation>
        </message>
    </context>
    <context>
        <name>ArchiveView</name>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Import Folder</source>
            <translation>Імпорт теки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Serial number, date, plan, operator, verdict … (Ctrl+F)</source>
            <translation>Заводський номер, дата, план, оператор, рішення… (Ctrl+F)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Search the archive</source>
            <translation>Пошук в архіві</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Kind of entries</source>
            <translation>Вид записів</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Parameter that is followed</source>
            <translation>Параметр, за яким стежать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Temperature of what counts</source>
            <translation>Температура того, що рахується</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Only calibrations at about this temperature count; the others are shown</source>
            <translation>Рахуються лише калібрування приблизно за цієї температури; решту показано</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Entries</source>
            <translation>Записи архіву</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Serial no.</source>
            <translation>Зав. №</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Kind</source>
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Measured</source>
            <translation>Виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Verdict</source>
            <translation>Рішення</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Operator</source>
            <translation>Оператор</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Plan or procedure</source>
            <translation>План або метод</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>all kinds</source>
            <translation>усі види</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>sessions</source>
            <translation>сеанси</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>calibrations</source>
            <translation>калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>run files</source>
            <translation>файли серій</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>old files</source>
            <translation>старі файли</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>records</source>
            <translation>записи</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>means</source>
            <translation>середні</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>noise</source>
            <translation>шум</translation>
        </message>
    </context>
    <context>
        <name>Banner</name>
        <message>
            <location filename="../../gui/widgets/banner.py" />
            <source>Close this message</source>
            <translation>Закрити це повідомлення</translation>
        </message>
    </context>
    <context>
        <name>BytesView</name>
        <message>
            <location filename="../../gui/frames/bytes_view.py" />
            <source>Choose the port of the board and its baud rate, and press Listen; or open a raw log. Frames, checksum and numbers are then looked for by themselves.</source>
            <translation>Виберіть порт плати і його швидкість та натисніть «Слухати»; або відкрийте необроблений журнал. Кадри, контрольну суму і числа буде знайдено самостійно.</translation>
        </message>
    </context>
    <context>
        <name>Callout</name>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>{number} of {count}</source>
            <translation>{number} з {count}</translation>
        </message>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>Leave the tour</source>
            <translation>Залишити огляд</translation>
        </message>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>Back</source>
            <translation>Назад</translation>
        </message>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>Done</source>
            <translation>Готово</translation>
        </message>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>Next</source>
            <translation>Далі</translation>
        </message>
    </context>
    <context>
        <name>Certificate</name>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Method</source>
            <translation>Метод</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Conditions</source>
            <translation>Умови</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Results</source>
            <translation>Результати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Before adjustment</source>
            <translation>До регулювання</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Remarks</source>
            <translation>Примітки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Calibration certificate</source>
            <translation>Сертифікат калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Replaces certificate No. {number}, which holds no longer.</source>
            <translation>Замінює сертифікат № {number}, який більше не чинний.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>CALIBRATION CERTIFICATE</source>
            <translation>СЕРТИФІКАТ КАЛІБРУВАННЯ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>No.</source>
            <translation>№</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Customer</source>
            <translation>Замовник</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Item</source>
            <translation>Виріб</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Serial number</source>
            <translation>Заводський номер</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Condition of the item</source>
            <translation>Стан виробу</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Received</source>
            <translation>Отримано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Calibrated</source>
            <translation>Калібровано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Issued</source>
            <translation>Видано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Place</source>
            <translation>Місце</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>What was changed</source>
            <translation>Що змінено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The results relate only to the item calibrated.</source>
            <translation>Результати стосуються лише каліброваного виробу.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The certificate may be reproduced only in full.</source>
            <translation>Сертифікат дозволено відтворювати лише повністю.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>End of the certificate</source>
            <translation>Кінець сертифіката</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Accreditation</source>
            <translation>Акредитація</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Procedure</source>
            <translation>Методика</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Plan</source>
            <translation>План</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Measured</source>
            <translation>Виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Records</source>
            <translation>Записи</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Software</source>
            <translation>Програма</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Air temperature</source>
            <translation>Температура повітря</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Relative humidity</source>
            <translation>Відносна вологість</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Air pressure</source>
            <translation>Атмосферний тиск</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Supply of the item</source>
            <translation>Живлення виробу</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Temperature of the item</source>
            <translation>Температура виробу</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Local gravity g</source>
            <translation>Місцеве прискорення тяжіння g</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standard uncertainty of a head setting</source>
            <translation>Стандартна невизначеність установлення головки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standard uncertainty of a table rate</source>
            <translation>Стандартна невизначеність швидкості стенда</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standards used and their traceability</source>
            <translation>Застосовані еталони та їх простежуваність</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standard</source>
            <translation>Еталон</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Certificate</source>
            <translation>Сертифікат</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Valid until</source>
            <translation>Дійсний до</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Traceable to</source>
            <translation>Простежуваність до</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The positions leave no degree of freedom: no uncertainty can be stated.</source>
            <translation>Положення не залишають ступеня вільності: невизначеність указати неможливо.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The stated intervals are two-sided, for a coverage probability of 95 %, from the profile of the likelihood; U is the larger of their two halves. Of what was not detected the one-sided limit is stated (&lt;), for the same probability.</source>
            <translation>Наведені інтервали двобічні, для ймовірності охоплення 95 %, за профілем правдоподібності; U - більша з двох їхніх половин. Для того, чого не виявлено, наведено однобічну межу (&lt;) для тієї самої ймовірності.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The stated uncertainty is the expanded uncertainty U: the standard uncertainty times the coverage factor {span}, for a normal distribution and a coverage probability of 95 %.</source>
            <translation>Зазначена невизначеність є розширеною невизначеністю U: стандартна невизначеність, помножена на коефіцієнт охоплення {span}, для нормального розподілу і ймовірності охоплення 95 %.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The stated uncertainty is the expanded uncertainty U: the standard uncertainty times the coverage factor {span}, Student's t for the effective degrees of freedom of each result, for a coverage probability of 95 %.</source>
            <translation>Зазначена невизначеність є розширеною невизначеністю U: стандартна невизначеність, помножена на коефіцієнт охоплення {span}, t Стьюдента для ефективних ступенів вільності кожного результату, для ймовірності охоплення 95 %.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Sensor</source>
            <translation>Датчик</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Parameter</source>
            <translation>Параметр</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Verdict</source>
            <translation>Рішення</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Deviation</source>
            <translation>Відхил</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>± U (95 %)</source>
            <translation>± U (95 %)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>± Limit</source>
            <translation>± межа</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Unit</source>
            <translation>Одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Conformity</source>
            <translation>Відповідність</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Decision rule</source>
            <translation>Правило рішення</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Statement of conformity</source>
            <translation>Заява про відповідність</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>PASS</source>
            <translation>ВІДПОВІДАЄ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>FAIL</source>
            <translation>НЕ ВІДПОВІДАЄ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>UNDECIDED</source>
            <translation>НЕ ВИРІШЕНО</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Authorised by</source>
            <translation>Затвердив</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>{title}, further columns</source>
            <translation>{title}, решта стовпців</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Residuals by position</source>
            <translation>Залишки за положеннями</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Remark</source>
            <translation>Зауваження</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Warning</source>
            <translation>Попередження</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Error</source>
            <translation>Помилка</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/pdf.py" />
            <source>Page {number} of {count}</source>
            <translation>Сторінка {number} з {count}</translation>
        </message>
    </context>
    <context>
        <name>CertificateTab</name>
        <message>
            <location filename="../../gui/certificate/limits.py" />
            <source>{text} is no number</source>
            <translation>{text} не є числом</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits.py" />
            <source>a limit must be above zero</source>
            <translation>межа має бути більша за нуль</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>No certificate can be made of these results</source>
            <translation>З цих результатів сертифікат не скласти</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The certificate cannot be read</source>
            <translation>Сертифікат неможливо прочитати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>A withdrawal needs a reason</source>
            <translation>Відкликання потребує причини</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>Missing: {list}.</source>
            <translation>Бракує: {list}.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The certificate is not complete</source>
            <translation>Сертифікат неповний</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>What is issued gets its number for ever.</source>
            <translation>Виданий сертифікат отримує номер назавжди.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>Issue all the same</source>
            <translation>Видати попри це</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The laboratory's file is refused</source>
            <translation>Файл лабораторії відхилено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The laboratory's file is not written</source>
            <translation>Файл лабораторії не записано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>No. {number} is issued, its PDF is not written</source>
            <translation>№ {number} видано, його PDF не записано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>Write PDF and HTML does it once there is room.</source>
            <translation>«Записати PDF і HTML» зробить це, коли буде місце.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>No. {number} is issued</source>
            <translation>№ {number} видано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>{name}, with HTML and JSON, in the folder certificates of the sessions.</source>
            <translation>{name}, з HTML і JSON, у теці certificates сеансів.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The certificate could not be worked on</source>
            <translation>З сертифікатом неможливо працювати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/scene.py" />
            <source>Process a calibration or a check in its tab and press Certificate on the page of its results; or load a session, a run file, an old file or a calibration here (Ctrl+O).</source>
            <translation>Обробіть калібрування або перевірку в їх вкладці й натисніть «Сертифікат» на сторінці результатів; або завантажте тут сеанс, файл серії, старий файл чи калібрування (Ctrl+O).</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/scene.py" />
            <source>There are no results yet</source>
            <translation>Результатів ще немає</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/scene.py" />
            <source>Files are being read or written</source>
            <translation>Файли читаються або записуються</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>name of the laboratory</source>
            <translation>назва лабораторії</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>address of the laboratory</source>
            <translation>адреса лабораторії</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>person who authorises</source>
            <translation>особа, що затверджує</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>standards and their traceability</source>
            <translation>еталони та їх простежуваність</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>customer</source>
            <translation>замовник</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>contact of the customer</source>
            <translation>контакт замовника</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>item</source>
            <translation>виріб</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>serial number of the item</source>
            <translation>заводський номер виробу</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>condition of the item</source>
            <translation>стан виробу</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>date of calibration</source>
            <translation>дата калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>date of issue</source>
            <translation>дата видачі</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>ambient temperature</source>
            <translation>температура довкілля</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>results</source>
            <translation>результати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>uncertainty of the results</source>
            <translation>невизначеність результатів</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>what was changed, and why</source>
            <translation>що змінено і чому</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>guard band U (JCGM 106)</source>
            <translation>захисна смуга U (JCGM 106)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>simple acceptance (ILAC-G8)</source>
            <translation>просте прийняття (ILAC-G8)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Residuals by position</source>
            <translation>Залишки за положеннями</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Matrices {names}</source>
            <translation>Матриці {names}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Process them again in their tab, then press Certificate there.</source>
            <translation>Обробіть їх знову в їхній вкладці, потім натисніть там «Сертифікат».</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Correct the place that is named, or move the file away and fill in the page Laboratory anew; until then nothing is written over it.</source>
            <translation>Виправте назване місце або перенесіть файл і заповніть сторінку «Лабораторія» знову; доти його нічим не буде перезаписано.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Its PDF and HTML still hold; take its JSON from a copy of the folder.</source>
            <translation>Його PDF і HTML ще чинні; візьміть його JSON з копії теки.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Type why it holds no longer, then press Withdraw again.</source>
            <translation>Введіть, чому він більше не чинний, потім натисніть «Відкликати» знову.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Nothing was issued. Put right what is named, then do the same again.</source>
            <translation>Нічого не видано. Виправте назване, потім повторіть.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>damaged</source>
            <translation>пошкоджено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>withdrawn</source>
            <translation>відкликано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>replaced by {number}</source>
            <translation>замінено на {number}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>valid</source>
            <translation>чинний</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Issue</source>
            <translation>Видати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Load Data</source>
            <translation>Завантажити дані</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Back to the draft</source>
            <translation>Назад до чернетки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Replace</source>
            <translation>Замінити</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>It was replaced or withdrawn before</source>
            <translation>Його вже замінено або відкликано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Write PDF and HTML</source>
            <translation>Записати PDF і HTML</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>They are there; nothing is overwritten</source>
            <translation>Вони вже є; нічого не перезаписується</translation>
        </message>
    </context>
    <context>
        <name>CertificateView</name>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>No results yet</source>
            <translation>Результатів ще немає</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>No. {number}, issued</source>
            <translation>№ {number}, видано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Draft No. {number}</source>
            <translation>Чернетка № {number}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>ISO/IEC 17025 asks for: {list}</source>
            <translation>ISO/IEC 17025 вимагає: {list}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Results for a certificate</source>
            <translation>Результати для сертифіката</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Calibrations, sessions, runs (*.json *.jsonl *.csv *.txt)</source>
            <translation>Калібрування, сеанси, серії (*.json *.jsonl *.csv *.txt)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Order</source>
            <translation>Замовлення</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Limits</source>
            <translation>Межі</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Laboratory</source>
            <translation>Лабораторія</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Issued</source>
            <translation>Видано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Parts of the form</source>
            <translation>Частини форми</translation>
        </message>
    </context>
    <context>
        <name>ChanceBar</name>
        <message>
            <location filename="../../gui/discrepancy/candidate_view.py" />
            <source>{chance} % to decide</source>
            <translation>{chance} % на рішення</translation>
        </message>
    </context>
    <context>
        <name>ChartsView</name>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Full time scale</source>
            <translation>Увесь час</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Auto tracking</source>
            <translation>Автостеження</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>X Cursor</source>
            <translation>Курсор X</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Pause</source>
            <translation>Пауза</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Edit mode</source>
            <translation>Режим правки</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Overlay…</source>
            <translation>Накласти…</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>No overlay</source>
            <translation>Без накладення</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Select all</source>
            <translation>Вибрати все</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Deselect all</source>
            <translation>Зняти вибір</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Select interval</source>
            <translation>Вибрати інтервал</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Show intervals</source>
            <translation>Показати інтервали</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Remove intervals</source>
            <translation>Прибрати інтервали</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Means</source>
            <translation>Середні</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Mark</source>
            <translation>Позначка</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Freezes the picture; the record goes on</source>
            <translation>Зупиняє картину; запис триває</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Marks this moment in the record, with the note</source>
            <translation>Позначає цей момент у записі разом із приміткою</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Averages the selected intervals and writes means.dat beside the record</source>
            <translation>Усереднює вибрані інтервали і пише means.dat поруч із записом</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Seconds of Auto tracking</source>
            <translation>Секунди автостеження</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Note</source>
            <translation>Примітка</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>what happens now; Enter marks it</source>
            <translation>що відбувається; Enter позначає</translation>
        </message>
    </context>
    <context>
        <name>ComparisonSide</name>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Results and runs (*.json *.csv *.txt)</source>
            <translation>Результати і серії (*.json *.csv *.txt)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Gyro</source>
            <translation>Гіроскоп</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>File</source>
            <translation>Файл</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Gyros that are compared</source>
            <translation>Гіроскопи, що порівнюються</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Add files</source>
            <translation>Додати файли</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Remove</source>
            <translation>Прибрати</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Local g, m/s²</source>
            <translation>Місцеве g, m/s²</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Taken where a file states none</source>
            <translation>Береться там, де файл його не вказує</translation>
        </message>
    </context>
    <context>
        <name>CompassContent</name>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>averaging time at each heading, s</source>
            <translation>час усереднення на кожному курсі, s</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>u of the heading, °</source>
            <translation>u курсу, °</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>wanted, {target}°</source>
            <translation>бажано, {target}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>as set, {u}°</source>
            <translation>як задано, {u}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>best, {u}°</source>
            <translation>найкраще, {u}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>State the noise of the gyro at the left, or take it from a record: then this curve shows how long to average.</source>
            <translation>Вкажіть ліворуч шум гіроскопа або візьміть його із запису: тоді ця крива покаже, як довго усереднювати.</translation>
        </message>
    </context>
    <context>
        <name>CompassSide</name>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Output</source>
            <translation>Вихід</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Which gyro.</source>
            <translation>Який гіроскоп.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Headings</source>
            <translation>Курси</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>To plan for; a run that is loaded brings its own.</source>
            <translation>Для планування; завантажена серія має свої.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>North positive, south negative.</source>
            <translation>Північна додатна, південна від'ємна.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Scale factor</source>
            <translation>Масштаб. коеф.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Output for 1 °/s; 0 where the output is a rate.</source>
            <translation>Вихід на 1 °/s; 0, якщо вихід є швидкістю.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>u(tilt)</source>
            <translation>u(нахилу)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Of one reading of the tilt, k = 1.</source>
            <translation>Одного показу нахилу, k = 1.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Average</source>
            <translation>Усереднення</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>At each heading.</source>
            <translation>На кожному курсі.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Turning</source>
            <translation>Поворот</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Time to turn and settle before each heading.</source>
            <translation>Час на поворот і заспокоєння перед кожним курсом.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Wanted u</source>
            <translation>Бажане u</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Standard uncertainty of the heading; 0 for none.</source>
            <translation>Стандартна невизначеність курсу; 0 — немає.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>not stated</source>
            <translation>не вказано</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>The drift changes steadily</source>
            <translation>Дрейф рівномірно змінюється</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Estimate its change; needs times and five readings.</source>
            <translation>Оцінити його зміну; потрібні часи і п'ять показів.</translation>
        </message>
    </context>
    <context>
        <name>CompassView</name>
        <message>
            <location filename="../../gui/gyrocompass/compass_view.py" />
            <source>Compass</source>
            <translation>Компас</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/compass_view.py" />
            <source>Heading: not measured yet</source>
            <translation>Курс: ще не виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/compass_view.py" />
            <source>Heading {value}° ± {half}°</source>
            <translation>Курс {value}° ± {half}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/compass_view.py" />
            <source>wedge: 95 %, drawn {count} times as wide</source>
            <translation>клин: 95 %, намальовано у {count} разів ширшим</translation>
        </message>
    </context>
    <context>
        <name>DefinitionView</name>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Both meanings are shown; the stream says which one fits.</source>
            <translation>Показано обидва значення; потік каже, яке підходить.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Header</source>
            <translation>Заголовок</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Length</source>
            <translation>Довжина</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Checksum</source>
            <translation>Контрольна сума</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Device name</source>
            <translation>Назва пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Kind</source>
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source> bytes</source>
            <translation> байтів</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Save device file</source>
            <translation>Зберегти файл пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Save and connect</source>
            <translation>Зберегти і під'єднати</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>what the operators call the board</source>
            <translation>як оператори називають плату</translation>
        </message>
    </context>
    <context>
        <name>DeviceStrip</name>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Hz</source>
            <translation>Hz</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>not connected</source>
            <translation>не під'єднано</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>opening</source>
            <translation>відкривається</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>streaming</source>
            <translation>передає</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>open, no data</source>
            <translation>відкрито, даних немає</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>link lost</source>
            <translation>зв'язок втрачено</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Properties</source>
            <translation>Властивості</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Device Properties: number, port, baud rate, scan</source>
            <translation>Властивості пристроїв: кількість, порт, швидкість, пошук</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Device</source>
            <translation>Пристрій</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>View ADC Data, Stop Device</source>
            <translation>Дані АЦП, зупинка пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Temperature of the device</source>
            <translation>Температура пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>frames</source>
            <translation>кадри</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Frames received with a right checksum</source>
            <translation>Отримано кадрів з правильною контрольною сумою</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>bytes</source>
            <translation>байти</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Bytes received</source>
            <translation>Отримано байтів</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>bad</source>
            <translation>хибні</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Frames with a wrong checksum</source>
            <translation>Кадри з неправильною контрольною сумою</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>lost</source>
            <translation>втрачено</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Samples sent by the device that never came</source>
            <translation>Відліки, надіслані пристроєм, що не дійшли</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>garbage</source>
            <translation>сміття</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Bytes that belong to no frame</source>
            <translation>Байти, що не належать жодному кадру</translation>
        </message>
    </context>
    <context>
        <name>DevicesView</name>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device Properties</source>
            <translation>Властивості пристроїв</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Number of Devices</source>
            <translation>Кількість пристроїв</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device name</source>
            <translation>Назва пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Port Name</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>BaudRate</source>
            <translation>Швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device file</source>
            <translation>Файл пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Scan</source>
            <translation>Пошук</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Listens at every baud rate; nothing is sent</source>
            <translation>Слухає на кожній швидкості; нічого не надсилає</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Refresh ports</source>
            <translation>Оновити порти</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Stop scanning</source>
            <translation>Зупинити пошук</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>OK</source>
            <translation>OK</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Ask for names</source>
            <translation>Запитати назви</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Do not ask</source>
            <translation>Не запитувати</translation>
        </message>
    </context>
    <context>
        <name>Dial</name>
        <message>
            <location filename="../../gui/rig/dial_view.py" />
            <source>Dividing head</source>
            <translation>Ділильна головка</translation>
        </message>
    </context>
    <context>
        <name>DiscrepancyView</name>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>Load Data</source>
            <translation>Завантажити дані</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>Measurements (*.run.csv *.txt session.json)</source>
            <translation>Вимірювання (*.run.csv *.txt session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>Where the residual has structure</source>
            <translation>Де залишок має структуру</translation>
        </message>
    </context>
    <context>
        <name>DistanceView</name>
        <message>
            <location filename="../../gui/widgets/distance_view.py" />
            <source>Next: {step}</source>
            <translation>Далі: {step}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/distance_view.py" />
            <source>Esc leaves</source>
            <translation>Esc — вихід</translation>
        </message>
    </context>
    <context>
        <name>DriftView</name>
        <message>
            <location filename="../../gui/drift/view.py" />
            <source>Turn-ons (*.calrec *.run.csv *.txt *.csv *.dat)</source>
            <translation>Увімкнення (*.calrec *.run.csv *.txt *.csv *.dat)</translation>
        </message>
        <message>
            <location filename="../../gui/drift/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
    </context>
    <context>
        <name>ErrorGraph</name>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>set angle, deg</source>
            <translation>заданий кут, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>{title}; limit ±{limit} lies outside</source>
            <translation>{title}; межа ±{limit} лежить за полем</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>limit ±{limit}°</source>
            <translation>межа ±{limit}°</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>now {value}°</source>
            <translation>зараз {value}°</translation>
        </message>
    </context>
    <context>
        <name>ExportFoot</name>
        <message>
            <location filename="../../gui/widgets/export_foot.py" />
            <source>Export format</source>
            <translation>Формат експорту</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/export_foot.py" />
            <source>File of the export</source>
            <translation>Файл експорту</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/export_foot.py" />
            <source>Export</source>
            <translation>Експорт</translation>
        </message>
    </context>
    <context>
        <name>FieldForm</name>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Name</source>
            <translation>Назва</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Type</source>
            <translation>Тип</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Scale</source>
            <translation>Масштаб</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Offset</source>
            <translation>Зсув</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Unit</source>
            <translation>Одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Role</source>
            <translation>Роль</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>little endian</source>
            <translation>молодший байт перший</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>big endian</source>
            <translation>старший байт перший</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Byte order</source>
            <translation>Порядок байтів</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>A number or an expression, such as 20*9.80665/65536</source>
            <translation>Число або вираз, наприклад 20*9.80665/65536</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Tells the program what it measures: acc in m/s^2, rate in deg/s, temp in degC</source>
            <translation>Каже програмі, що вимірюється: acc у m/s^2, rate у deg/s, temp у degC</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>No channel</source>
            <translation>Не канал</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Add field</source>
            <translation>Додати поле</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Makes numbers of the bytes pointed at (Enter)</source>
            <translation>Робить числа з позначених байтів (Enter)</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Remove field</source>
            <translation>Прибрати поле</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Takes away the fields on the bytes pointed at (Delete)</source>
            <translation>Прибирає поля на позначених байтах (Delete)</translation>
        </message>
    </context>
    <context>
        <name>FindingsView</name>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Nothing is undecided: no further measurement is proposed.</source>
            <translation>Нічого не лишилося невирішеним: подальших вимірювань не пропонується.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>No series that was tried is likely to tell these names apart.</source>
            <translation>Жодна з перевірених серій навряд чи розрізнить ці назви.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Keep this plan</source>
            <translation>Зберегти цей план</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Open this plan</source>
            <translation>Відкрити цей план</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>From which size on these rows name an effect</source>
            <translation>Від якої величини ці рядки називають ефект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Candidates</source>
            <translation>Кандидати</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Measure next</source>
            <translation>Виміряти далі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>What can be seen</source>
            <translation>Що можна побачити</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Measure next ({count})</source>
            <translation>Виміряти далі ({count})</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Practice</source>
            <translation>Вправа</translation>
        </message>
    </context>
    <context>
        <name>FramesView</name>
        <message>
            <location filename="../../gui/frames/view.py" />
            <source>Bytes of the stream, one frame a row</source>
            <translation>Байти потоку, по кадру в рядку</translation>
        </message>
        <message>
            <location filename="../../gui/frames/view.py" />
            <source>Numbers of the board</source>
            <translation>Числа плати</translation>
        </message>
    </context>
    <context>
        <name>GapBar</name>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>gap {gap}</source>
            <translation>розбіжність {gap}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Gap {gap} noise floors; rows left out of the fit: {held}</source>
            <translation>Розбіжність {gap} рівнів шуму; рядки, вилучені з оцінки: {held}</translation>
        </message>
    </context>
    <context>
        <name>HarmonicsView</name>
        <message>
            <location filename="../../gui/tumble/harmonics_view.py" />
            <source>Harmonics</source>
            <translation>Гармоніки</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/harmonics_view.py" />
            <source>|C|, {unit}; dashes: what noise alone exceeds in 1 % of cases</source>
            <translation>|C|, {unit}; штрихи: що сам шум перевищує в 1 % випадків</translation>
        </message>
    </context>
    <context>
        <name>HeadForm</name>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>u(head angle), arcsec</source>
            <translation>u(кута головки), arcsec</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Base orientation</source>
            <translation>Базова орієнтація</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Tilter</source>
            <translation>Нахилювач</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Tilter No.</source>
            <translation>Нахилювач №</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Position</source>
            <translation>Положення</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Free angle</source>
            <translation>Довільний кут</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>None</source>
            <translation>Немає</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Auto</source>
            <translation>Авто</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Manual</source>
            <translation>Вручну</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Add</source>
            <translation>Додати</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Mount of the free angle</source>
            <translation>Встановлення для довільного кута</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Free angle, deg</source>
            <translation>Довільний кут, deg</translation>
        </message>
    </context>
    <context>
        <name>HistoryPlot</name>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>mean ± s</source>
            <translation>середнє ± s</translation>
        </message>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>limits</source>
            <translation>межі</translation>
        </message>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>value ± U</source>
            <translation>значення ± U</translation>
        </message>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>not counted</source>
            <translation>не враховано</translation>
        </message>
    </context>
    <context>
        <name>KeysView</name>
        <message>
            <location filename="../../gui/keys/view.py" />
            <source>Find a key or what it does</source>
            <translation>Знайти клавішу або її дію</translation>
        </message>
        <message>
            <location filename="../../gui/keys/view.py" />
            <source>Save as PDF</source>
            <translation>Зберегти як PDF</translation>
        </message>
        <message>
            <location filename="../../gui/keys/view.py" />
            <source>Close</source>
            <translation>Закрити</translation>
        </message>
    </context>
    <context>
        <name>KnotPlot</name>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>drift, {unit}</source>
            <translation>дрейф, {unit}</translation>
        </message>
    </context>
    <context>
        <name>LaboratoryForm</name>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Pictures (*.png *.jpg *.jpeg *.svg)</source>
            <translation>Рисунки (*.png *.jpg *.jpeg *.svg)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Kept in laboratory.json in the folder of sessions, for all certificates.</source>
            <translation>Зберігається в laboratory.json у теці сеансів, для всіх сертифікатів.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Laboratory</source>
            <translation>Лабораторія</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Address</source>
            <translation>Адреса</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Place</source>
            <translation>Місце</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Accreditation</source>
            <translation>Акредитація</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Logo</source>
            <translation>Логотип</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Authorised by</source>
            <translation>Затвердив</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Position</source>
            <translation>Посада</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Number</source>
            <translation>Номер</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Further text</source>
            <translation>Додатковий текст</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>of calibration, if it is another one</source>
            <translation>калібрування, якщо інше</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>number and body, if any</source>
            <translation>номер і орган, якщо є</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>picture, PNG, JPEG or SVG</source>
            <translation>рисунок, PNG, JPEG або SVG</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>at the end of every certificate</source>
            <translation>наприкінці кожного сертифіката</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>{year} and {n} are replaced; {n:04d} is the number with four digits</source>
            <translation>{year} і {n} замінюються; {n:04d} — номер із чотирьох цифр</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Choose logo</source>
            <translation>Вибрати логотип</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Standards</source>
            <translation>Еталони</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Add</source>
            <translation>Додати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Remove</source>
            <translation>Прибрати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Standards and their traceability</source>
            <translation>Еталони та їх простежуваність</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Standard</source>
            <translation>Еталон</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Serial no.</source>
            <translation>Зав. №</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Certificate</source>
            <translation>Сертифікат</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Valid until</source>
            <translation>Дійсний до</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Traceable to</source>
            <translation>Простежуваність до</translation>
        </message>
    </context>
    <context>
        <name>LadderView</name>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>The ladder</source>
            <translation>Драбина</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Bars: gap in noise floors (dotted: the floor, 1). Stroke: rows left out.</source>
            <translation>Смуги: розбіжність у рівнях шуму (пунктир: рівень, 1). Риска: вилучені рядки.</translation>
        </message>
    </context>
    <context>
        <name>LimitsForm</name>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Conformity: {verdict}</source>
            <translation>Відповідність: {verdict}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>A parameter with a limit is judged: its deviation from the nominal value, 0 if none is given, in all sensors that have it. A check brings its verdict with it.</source>
            <translation>Параметр із межею оцінюється: його відхил від номінального значення (0, якщо не задано) в усіх датчиках, що його мають. Перевірка приносить своє рішення з собою.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Decision rule</source>
            <translation>Правило рішення</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Printed</source>
            <translation>Друкується</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Limits of the parameters</source>
            <translation>Межі параметрів</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Parts of the results that are printed</source>
            <translation>Частини результатів, що друкуються</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Parameter</source>
            <translation>Параметр</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Nominal</source>
            <translation>Номінал</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>± Limit</source>
            <translation>± межа</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Unit</source>
            <translation>Одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Found</source>
            <translation>Знайдено</translation>
        </message>
    </context>
    <context>
        <name>LiveTable</name>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Accelerations</source>
            <translation>Прискорення</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Angular Rates</source>
            <translation>Кут. швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Mean ({unit})</source>
            <translation>Середнє ({unit})</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>STD ({unit})</source>
            <translation>СКВ ({unit})</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Termo (code)</source>
            <translation>Термо (code)</translation>
        </message>
    </context>
    <context>
        <name>LiveView</name>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Packed count {n}</source>
            <translation>Пакетів: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>lost {n}</source>
            <translation>втрачено {n}</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>on disk {mb} MB</source>
            <translation>на диску {mb} MB</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>disk lasts {time}</source>
            <translation>диска вистачить на {time}</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Records</source>
            <translation>Записи</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Records (*.calrec *.txt)</source>
            <translation>Записи (*.calrec *.txt)</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Charts</source>
            <translation>Графіки</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Table</source>
            <translation>Таблиця</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Means</source>
            <translation>Середні</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Save</source>
            <translation>Зберегти</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Format</source>
            <translation>Формат</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>File to save</source>
            <translation>Файл для збереження</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Status</source>
            <translation>Стан</translation>
        </message>
    </context>
    <context>
        <name>LogDrawer</name>
        <message>
            <location filename="../../gui/widgets/log_drawer.py" />
            <source>Log</source>
            <translation>Журнал</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/log_drawer.py" />
            <source>Show or hide the log (Ctrl+L)</source>
            <translation>Показати або сховати журнал (Ctrl+L)</translation>
        </message>
    </context>
    <context>
        <name>MainWindow</name>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Menu</source>
            <translation>Меню</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Look, sounds, keys, preferences (F10)</source>
            <translation>Вигляд, звуки, клавіші, налаштування (F10)</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Simulated rig</source>
            <translation>Симульований стенд</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>View ADC Data</source>
            <translation>Дані АЦП</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Stop Device</source>
            <translation>Зупинити пристрій</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Start Device</source>
            <translation>Запустити пристрій</translation>
        </message>
    </context>
    <context>
        <name>MeansView</name>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Means of the selection</source>
            <translation>Середні вибраного</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Of the selected intervals, else from A to B, else of everything on the charts</source>
            <translation>З вибраних інтервалів, інакше від A до B, інакше з усього на графіках</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Means of a folder…</source>
            <translation>Середні теки…</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Mean ± its standard error, which respects correlated noise. Enter what was set for each record, or paste a column of it; the run file then goes into the fit.</source>
            <translation>Середнє ± його стандартна похибка з урахуванням корельованого шуму. Введіть, що було задано для кожного запису, або вставте стовпець; тоді файл серії йде на оцінювання.</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>For the fit of the</source>
            <translation>Для оцінювання</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>rate table: set rate, °/s</source>
            <translation>поворотний стенд: задана швидкість, °/s</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>dividing head: X_from:90</source>
            <translation>ділильна головка: X_from:90</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Run file</source>
            <translation>Файл серії</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Write run file</source>
            <translation>Записати файл серії</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Means</source>
            <translation>Середні</translation>
        </message>
    </context>
    <context>
        <name>MeasuringView</name>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Folder of the session; can be changed</source>
            <translation>Тека сеансу; можна змінити</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Load Data</source>
            <translation>Завантажити дані</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Measurements (*.txt *.run.csv session.json)</source>
            <translation>Вимірювання (*.txt *.run.csv session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Plan</source>
            <translation>План</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>What can this plan show?</source>
            <translation>Що може показати цей план?</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Session</source>
            <translation>Сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Name of the session's folder</source>
            <translation>Назва теки сеансу</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>New session</source>
            <translation>Новий сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Main Graph</source>
            <translation>Головний графік</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>The graph begins when samples come.</source>
            <translation>Графік почнеться, коли прийдуть відліки.</translation>
        </message>
    </context>
    <context>
        <name>MethodsView</name>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Which procedure?</source>
            <translation>Який метод?</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Fourier tumble</source>
            <translation>Оберт за Фур'є</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Gyrocompass</source>
            <translation>Гірокомпас</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Compare gyros</source>
            <translation>Порівняння гіроскопів</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Methods</source>
            <translation>Методи</translation>
        </message>
    </context>
    <context>
        <name>NoiseFields</name>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Records (*.calrec *.txt *.csv *.dat)</source>
            <translation>Записи (*.calrec *.txt *.csv *.dat)</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>White noise N</source>
            <translation>Білий шум N</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Two-sided density, as the Allan tab tells it.</source>
            <translation>Двостороння густина, як її показує вкладка Аллана.</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Flicker B</source>
            <translation>Флікер B</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Floor of the Allan curve over 0.664.</source>
            <translation>Дно кривої Аллана, поділене на 0,664.</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Walk K</source>
            <translation>Блукання K</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Random walk of the rate or of the acceleration.</source>
            <translation>Випадкове блукання швидкості або прискорення.</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Noise from a record …</source>
            <translation>Шум із запису…</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Analyse a record of the sensor at rest, as the Allan tab</source>
            <translation>Аналізує запис датчика в спокої, як вкладка Аллана</translation>
        </message>
    </context>
    <context>
        <name>OrderForm</name>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>year-month-day</source>
            <translation>рік-місяць-день</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Surroundings</source>
            <translation>Довкілля</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Customer</source>
            <translation>Замовник</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Contact</source>
            <translation>Контакт</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Item</source>
            <translation>Виріб</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Type</source>
            <translation>Тип</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Serial number</source>
            <translation>Заводський номер</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Condition</source>
            <translation>Стан</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Received</source>
            <translation>Отримано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Calibrated</source>
            <translation>Калібровано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Issued</source>
            <translation>Видано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Before adjustment</source>
            <translation>До регулювання</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Remarks</source>
            <translation>Примітки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Replaces No.</source>
            <translation>Замінює №</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>What was changed</source>
            <translation>Що змінено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>name and address</source>
            <translation>назва й адреса</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>e.g. inclinometer, triad of accelerometers</source>
            <translation>напр. інклінометр, тріада акселерометрів</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>e.g. without visible damage</source>
            <translation>напр. без видимих пошкоджень</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>what was found, or that nothing was adjusted</source>
            <translation>що виявлено, або що нічого не регулювали</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>deviations from the method, opinions</source>
            <translation>відхилення від методики, думки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>and why</source>
            <translation>і чому</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Air temperature, °C</source>
            <translation>Температура повітря, °C</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Relative humidity, %</source>
            <translation>Відносна вологість, %</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Air pressure, hPa</source>
            <translation>Атмосферний тиск, hPa</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Supply of the item, V</source>
            <translation>Живлення виробу, V</translation>
        </message>
    </context>
    <context>
        <name>OverviewView</name>
        <message>
            <location filename="../../gui/discrepancy/overview_view.py" />
            <source>times the noise floor; 1 is the best</source>
            <translation>рівнів шуму; найкраще — 1</translation>
        </message>
    </context>
    <context>
        <name>PlanView</name>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>What this rig can do, the best first</source>
            <translation>Що може цей стенд, найкраще — першим</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Steps: tick off what you would leave out</source>
            <translation>Кроки: зніміть позначку із зайвих</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Plans</source>
            <translation>Плани</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Steps</source>
            <translation>Кроки</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Mount of the step to add</source>
            <translation>Встановлення кроку, що додається</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Angle or rate of the step to add</source>
            <translation>Кут або швидкість кроку, що додається</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Add step</source>
            <translation>Додати крок</translation>
        </message>
    </context>
    <context>
        <name>PlotsView</name>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>output, {unit}</source>
            <translation>вихід, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated, plain model</source>
            <translation>симуляція, проста модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated, with the effects</source>
            <translation>симуляція, з ефектами</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>measured</source>
            <translation>виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated rig</source>
            <translation>імітований стенд</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>residual</source>
            <translation>залишок</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>structure</source>
            <translation>структура</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>95 % band for all points</source>
            <translation>смуга 95 % для всіх точок</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated rig less model</source>
            <translation>імітований стенд мінус модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>Output</source>
            <translation>Вихід</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>With the effects added</source>
            <translation>З доданими ефектами</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>this table</source>
            <translation>ця таблиця</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>left, {unit}</source>
            <translation>залишок, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Snap to blocks</source>
            <translation>Прив'язка до блоків</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Drag a knot with the mouse; or choose it by Page Up and Page Down and move it by the arrow keys.</source>
            <translation>Перетягніть вузол мишею або виберіть його Page Up і Page Down та рухайте стрілками.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Temperature</source>
            <translation>Температура</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Left on turn-ons that were not seen, rms</source>
            <translation>Залишається на не бачених увімкненнях, СКВ</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/plots_view.py" />
            <source>Quantity</source>
            <translation>Величина</translation>
        </message>
    </context>
    <context>
        <name>PolarView</name>
        <message>
            <location filename="../../gui/tumble/polar_view.py" />
            <source>Residuals by elevation</source>
            <translation>Залишки за кутом піднесення</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/polar_view.py" />
            <source>largest residual {value} {unit}</source>
            <translation>найбільший залишок {value} {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/polar_view.py" />
            <source>Residuals, {unit}; out is positive, shade: ±U (95 %)</source>
            <translation>Залишки, {unit}; назовні — додатні, тінь: ±U (95 %)</translation>
        </message>
    </context>
    <context>
        <name>PositionPicture</name>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>from the head</source>
            <translation>від головки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>to the head</source>
            <translation>до головки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>up</source>
            <translation>вгору</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>down</source>
            <translation>вниз</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>right</source>
            <translation>праворуч</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>left</source>
            <translation>ліворуч</translation>
        </message>
    </context>
    <context>
        <name>PreferencesView</name>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Sessions go there from the next start on; nothing is moved.</source>
            <translation>Сеанси йдуть туди з наступного запуску; нічого не переноситься.</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Gravity and latitude are taken by every tab that is not in the middle of a session; a tab may still state its own.</source>
            <translation>Прискорення тяжіння і широту бере кожна вкладка, що не посеред сеансу; вкладка може вказати свої.</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Folder of sessions</source>
            <translation>Тека сеансів</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Preferences</source>
            <translation>Налаштування</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Operator</source>
            <translation>Оператор</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Local g</source>
            <translation>Місцеве g</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>u(g)</source>
            <translation>u(g)</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Look</source>
            <translation>Вигляд</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Sounds</source>
            <translation>Звуки</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Language</source>
            <translation>Мова</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>stated in every session</source>
            <translation>вказується в кожному сеансі</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>not stated</source>
            <translation>не вказано</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Browse</source>
            <translation>Огляд…</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Close</source>
            <translation>Закрити</translation>
        </message>
    </context>
    <context>
        <name>PreviewView</name>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Page {number} of {count}</source>
            <translation>Сторінка {number} з {count}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Fit width</source>
            <translation>За шириною</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Whole page</source>
            <translation>Уся сторінка</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Size of the page</source>
            <translation>Розмір сторінки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Page before (Page Up)</source>
            <translation>Попередня сторінка (Page Up)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Page after (Page Down)</source>
            <translation>Наступна сторінка (Page Down)</translation>
        </message>
    </context>
    <context>
        <name>ProposalView</name>
        <message>
            <location filename="../../gui/discrepancy/candidate_view.py" />
            <source>Less likely</source>
            <translation>Менш імовірні</translation>
        </message>
    </context>
    <context>
        <name>RateForm</name>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>u(rate), deg/s</source>
            <translation>u(швидкості), deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>u(rate), ppm</source>
            <translation>u(швидкості), ppm</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>u(head angle), arcsec</source>
            <translation>u(кута головки), arcsec</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Full scale, deg/s</source>
            <translation>Повна шкала, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Latitude, deg</source>
            <translation>Широта, deg</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Rates of your own, deg/s</source>
            <translation>Власні швидкості, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Axis</source>
            <translation>Вісь</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Whole turns of the table</source>
            <translation>Цілі оберти стенда</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Each accumulation is made as long as whole turns nearest to the time above</source>
            <translation>Кожне накопичення триває стільки цілих обертів, щоб бути найближчим до часу вгорі</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>largest</source>
            <translation>макс.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>not stated</source>
            <translation>не задано</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Azimuth, deg</source>
            <translation>Азимут, deg</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Azimuth of the shaft, deg</source>
            <translation>Азимут вала, deg</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Up and down</source>
            <translation>Вгору і вниз</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Set</source>
            <translation>Задано</translation>
        </message>
    </context>
    <context>
        <name>RecordsPage</name>
        <message>
            <location filename="../../gui/widgets/records_page.py" />
            <source>Records</source>
            <translation>Записи</translation>
        </message>
    </context>
    <context>
        <name>RegisterList</name>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Choose one to see it. Nothing changes an issued certificate: Replace begins a new one that names it, Withdraw states that it holds no longer.</source>
            <translation>Виберіть один, щоб побачити його. Виданий сертифікат не змінюється: «Замінити» починає новий, що називає його, «Відкликати» засвідчує, що він більше не чинний.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>No.</source>
            <translation>№</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>State</source>
            <translation>Стан</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Serial no.</source>
            <translation>Зав. №</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Issued</source>
            <translation>Видано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Verdict</source>
            <translation>Рішення</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Item</source>
            <translation>Виріб</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Customer</source>
            <translation>Замовник</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Issued certificates</source>
            <translation>Видані сертифікати</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Reason</source>
            <translation>Причина</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Withdraw</source>
            <translation>Відкликати</translation>
        </message>
    </context>
    <context>
        <name>ResidualPlot</name>
        <message>
            <location filename="../../gui/widgets/residual_plot.py" />
            <source>Residuals by position</source>
            <translation>Залишки за положеннями</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/residual_plot.py" />
            <source>residual, {unit}; band: ±U (95 %)</source>
            <translation>залишок, {unit}; смуга: ±U (95 %)</translation>
        </message>
    </context>
    <context>
        <name>ResultTable</name>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Table of results</source>
            <translation>Таблиця результатів</translation>
        </message>
    </context>
    <context>
        <name>ResultsView</name>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>With: {effects}</source>
            <translation>З ефектами: {effects}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Certificate</source>
            <translation>Сертифікат</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Make a calibration certificate of these results</source>
            <translation>Скласти сертифікат калібрування з цих результатів</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Close the results</source>
            <translation>Закрити результати</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Model vs data</source>
            <translation>Модель і дані</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Compare the model with the rows: find out what it lacks</source>
            <translation>Порівняти модель з рядками: з'ясувати, чого їй бракує</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Take Out</source>
            <translation>Вилучити</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Calibrate by the plain model again</source>
            <translation>Калібрувати знову за простою моделлю</translation>
        </message>
    </context>
    <context>
        <name>RigPanel</name>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>moving</source>
            <translation>рухається</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>at rest</source>
            <translation>у спокої</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>table: {rate} deg/s about {axis}</source>
            <translation>стенд: {rate} deg/s навколо {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Unplug</source>
            <translation>Від'єднати</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Plug in</source>
            <translation>Під'єднати</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Operator turns it for me</source>
            <translation>Оператор повертає за мене</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Angle</source>
            <translation>Кут</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Mount</source>
            <translation>Установка</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Temperature</source>
            <translation>Температура</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Rate table</source>
            <translation>Стенд</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Angle of the head</source>
            <translation>Кут головки</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Turn</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Somebody sets every position that the test asks for</source>
            <translation>Хтось встановлює кожне положення, якого просить випробування</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Faults</source>
            <translation>Несправності</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Noise burst</source>
            <translation>Сплеск</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Noisy line</source>
            <translation>Завади</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Lost frames</source>
            <translation>Без кадрів</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Stuck channel</source>
            <translation>Зависання</translation>
        </message>
    </context>
    <context>
        <name>RowsPlot</name>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>measured − simulated, {unit}</source>
            <translation>виміряне − симульоване, {unit}</translation>
        </message>
    </context>
    <context>
        <name>RungView</name>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>proposed</source>
            <translation>пропозиція</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Take it back, with all above it</source>
            <translation>Прибрати його разом з усіма вище</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Take back {title}</source>
            <translation>Прибрати {title}</translation>
        </message>
    </context>
    <context>
        <name>SampleTable</name>
        <message>
            <location filename="../../gui/live/table_view.py" />
            <source>Table of samples</source>
            <translation>Таблиця відліків</translation>
        </message>
    </context>
    <context>
        <name>SettingsForm</name>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Accumulation Time, sec</source>
            <translation>Час накопичення, s</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Settling time, sec</source>
            <translation>Час заспокоєння, s</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Passes</source>
            <translation>Проходи</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Local g, m/s²</source>
            <translation>Місцеве g, m/s²</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>u(g), m/s²</source>
            <translation>u(g), m/s²</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Temperatures of the cycle, °C</source>
            <translation>Температури циклу, °C</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Temperatures, °C</source>
            <translation>Температури, °C</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Termo calibration</source>
            <translation>Термокалібрування</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Settings</source>
            <translation>Параметри</translation>
        </message>
    </context>
    <context>
        <name>SettingsView</name>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>none</source>
            <translation>немає</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>state it</source>
            <translation>вкажіть</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Channel</source>
            <translation>Канал</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Rate</source>
            <translation>Частота</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Samples per second; 0 takes that of the file.</source>
            <translation>Відліків за секунду; 0 бере частоту з файла.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Scale factor</source>
            <translation>Масштаб. коеф.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Output for 1 °/s (1 m/s²); the samples are divided by it.</source>
            <translation>Вихід на 1 °/s (1 m/s²); відліки діляться на нього.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Unit</source>
            <translation>Одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Of the samples, after the scale factor.</source>
            <translation>Відліків, після масштабного коефіцієнта.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Bandwidth</source>
            <translation>Смуга</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Of the sensor. A filter within the band falsifies N and B most.</source>
            <translation>Датчика. Фільтр усередині смуги найбільше спотворює N і B.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Regress on</source>
            <translation>Регресія</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Show the curve before and after taking off what this channel explains.</source>
            <translation>Показати криву до і після вилучення того, що пояснює цей канал.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Order</source>
            <translation>Порядок</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Highest power of that channel.</source>
            <translation>Найвищий степінь цього каналу.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Beside</source>
            <translation>Поруч</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Another deviation beside Allan's; needs the package AllanTools.</source>
            <translation>Інша девіація поруч з Аллановою; потребує пакета AllanTools.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>nothing</source>
            <translation>нічого</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Hadamard</source>
            <translation>Адамара</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>modified</source>
            <translation>модифікована</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>total</source>
            <translation>повна</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>found</source>
            <translation>авто</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Angle increments (fit Q)</source>
            <translation>Прирости кута (оцінити Q)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>The device sends increments of angle; a rate output has no quantisation Q.</source>
            <translation>Пристрій передає прирости кута; вихід швидкості не має квантування Q.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Chamber</source>
            <translation>Камера</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Of the chosen record; the same number for all turn-ons of one set.</source>
            <translation>Вибраного запису; однакове число для всіх увімкнень одного набору.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Start from</source>
            <translation>Початок від</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>The mean over this time is brought to zero, here and in use.</source>
            <translation>Середнє за цей час зводиться до нуля, тут і в роботі.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Start to</source>
            <translation>Початок до</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>The compensation works from here on.</source>
            <translation>Компенсація діє звідси.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Block</source>
            <translation>Блок</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Means over this time; long against noise, short against a bend.</source>
            <translation>Середні за цей час; довго для шуму, коротко для вигину.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Horizon</source>
            <translation>Горизонт</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>How long the compensation shall work.</source>
            <translation>Як довго має діяти компенсація.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Most knots tp</source>
            <translation>Вузлів до</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>What the microcontroller has room for.</source>
            <translation>На що вистачає місця в мікроконтролері.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Memory</source>
            <translation>Пам'ять</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Of times, temperatures and values, 2 bytes each.</source>
            <translation>Для часів, температур і значень, по 2 байти.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Knots</source>
            <translation>Вузли</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>By held-out turn-ons: the fewest that leave at most 2 % more.</source>
            <translation>За вилученими увімкненнями: найменше, що залишає щонайбільше на 2 % більше.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Output</source>
            <translation>Вихід</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Name or number of the channel.</source>
            <translation>Назва або номер каналу.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Samples per second, where the file does not tell it.</source>
            <translation>Відліків за секунду, якщо файл цього не каже.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Output for 1 °/s.</source>
            <translation>Вихід на 1 °/s.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>by the chip</source>
            <translation>кристал</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>whole record</source>
            <translation>увесь</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>by tp alone</source>
            <translation>за tp</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>of the file</source>
            <translation>з файла</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>likeliest</source>
            <translation>авто</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>none: see Properties above</source>
            <translation>немає: див. «Властивості» вгорі</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Device and Port Settings</source>
            <translation>Налаштування пристрою і порту</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Port</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Device #</source>
            <translation>Пристрій №</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Test</source>
            <translation>Випробування</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Profile #</source>
            <translation>Профіль №</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Sampling frequency</source>
            <translation>Дискретизація</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>as the device calls itself</source>
            <translation>як називає себе пристрій</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Static</source>
            <translation>Статичне</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Dynamic</source>
            <translation>Динамічне</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Rows a second of CVGCom's text file; the record keeps every sample</source>
            <translation>Рядків за секунду в текстовому файлі CVGCom; запис зберігає кожен відлік</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Write CVGCom's text file too</source>
            <translation>Писати й текст CVGCom</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>File name</source>
            <translation>Назва файла</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Channels</source>
            <translation>Канали</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Order of U0</source>
            <translation>Порядок U0</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Of the bias; of the outputs of a standing unit. Found: by temperatures left out.</source>
            <translation>Зміщення нуля; виходів нерухомого виробу. Знайдений: за вилученими температурами.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Order of k</source>
            <translation>Порядок k</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Of the scale factor.</source>
            <translation>Масштабного коефіцієнта.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>T0</source>
            <translation>T0</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>The constant terms hold at this temperature.</source>
            <translation>Сталі члени дійсні за цієї температури.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>g</source>
            <translation>g</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Taken where the files state none.</source>
            <translation>Береться там, де файли його не вказують.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Outputs</source>
            <translation>Виходи</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Of a record: names, between commas.</source>
            <translation>Запису: назви через кому.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>the first</source>
            <translation>перший</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>all rates</source>
            <translation>усі</translation>
        </message>
    </context>
    <context>
        <name>Shown</name>
        <message>
            <location filename="../../gui/accuracy/certified.py" />
            <source>Pitch</source>
            <translation>Тангаж</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/certified.py" />
            <source>Roll</source>
            <translation>Крен</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/certified.py" />
            <source>{kind} against the angles of the dividing head</source>
            <translation>{kind} за кутами ділильної головки</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>angles</source>
            <translation>кути</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>angle</source>
            <translation>кут</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>Angles</source>
            <translation>Кути</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>Turn to {dial}</source>
            <translation>Задайте {dial}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>{kind} {angle} ({dial}, {place})</source>
            <translation>{kind} {angle} ({dial}, {place})</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>dial {angle}</source>
            <translation>шкала {angle}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>No pitch, no roll</source>
            <translation>Ні тангажу, ні крену</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>{name} sends neither angles nor three accelerometers: there is nothing to check here. Choose another device.</source>
            <translation>{name} не передає ні кутів, ні трьох акселерометрів: тут нічого перевіряти. Виберіть інший пристрій.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>Nearest in the archive: {words}</source>
            <translation>Найближче в архіві: {words}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>The check has no calibration: only the unit's own angles are judged.</source>
            <translation>Перевірка не має калібрування: оцінюються лише власні кути виробу.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>Use judges the raw codes too, by this calibration.</source>
            <translation>«Узяти» оцінить за цим калібруванням і коди.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>Use</source>
            <translation>Узяти</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>{angle} error, deg</source>
            <translation>{angle}: похибка, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>deg</source>
            <translation>deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>{angle} while {other} is set, deg</source>
            <translation>{angle}, коли задано {other}, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>The unit tells no heading.</source>
            <translation>Виріб не передає курсу.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>Heading, change against the first row, deg</source>
            <translation>Курс, зміна відносно першого рядка, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>{angle}, deg</source>
            <translation>{angle}, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>code</source>
            <translation>code</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>Temperatures, change against the first row, {unit}</source>
            <translation>Температури, зміна відносно першого рядка, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>The unit tells no temperature.</source>
            <translation>Виріб не передає температури.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/results.py" />
            <source>No file is loaded.</source>
            <translation>Файл не завантажено.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/results.py" />
            <source>The file has {rows} rows, the list {angles} angles.</source>
            <translation>Файл має {rows} [рядок|рядки|рядків], список — {angles} [кут|кути|кутів].</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>The list belongs to the session; press New session to change it.</source>
            <translation>Список належить сеансу; щоб змінити його, натисніть «Новий сеанс».</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>The list Angles stays as it was</source>
            <translation>Список Angles лишається, як був</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>Type one angle for every row, in degrees, as 0, 30, 60; or press New session.</source>
            <translation>Введіть по одному куту на кожен рядок, у градусах, як 0, 30, 60; або натисніть «Новий сеанс».</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{device}: {kind} accuracy, {count} angles</source>
            <translation>{device}: точність, {kind}, {count} [кут|кути|кутів]</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{kind} Accuracy, deg</source>
            <translation>Точність, {kind}, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Trace</source>
            <translation>Крива</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Verdict</source>
            <translation>Рішення</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Set</source>
            <translation>Задано</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>in-plane angle atan2(a_y, a_z) less set angle: the pitch of a full turn</source>
            <translation>кут у площині atan2(a_y, a_z) мінус заданий: тангаж повного оберту</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>angle less set angle</source>
            <translation>кут мінус заданий</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Errors, deg, with U (95 %)</source>
            <translation>Похибки, deg, з U (95 %)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Table {number}: codes, m/s², deg</source>
            <translation>Таблиця {number}: коди, m/s², deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{kind} by the unit</source>
            <translation>{kind} за виробом</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{kind} calculated</source>
            <translation>{kind} обчислений</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>u of the calibration</source>
            <translation>u калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Calibration: {name}.</source>
            <translation>Калібрування: {name}.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>No calibration: the unit's own angles alone.</source>
            <translation>Без калібрування: лише власні кути виробу.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>No limit is stated: there is no verdict. {calibration}</source>
            <translation>Межу не вказано: рішення немає. {calibration}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Limit ±{limit}° at every angle. {rule}. U counts {parts}. {calibration}</source>
            <translation>Межа ±{limit}° для кожного кута. {rule}. U враховує {parts}. {calibration}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>the setting of the head, the resolution of reported angles, and the noise of the mean</source>
            <translation>установлення головки, роздільність кутів, що передаються, і шум середнього</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>largest error {error}° at {angle}°</source>
            <translation>найбільша похибка {error}° при {angle}°</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{count} of {total} angles</source>
            <translation>{count} з {total} [кута|кутів|кутів]</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Calibration</source>
            <translation>Калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Inter</source>
            <translation>Внутр.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Mags/Accels</source>
            <translation>Магн./аксел.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Tilter axes aligned</source>
            <translation>Осі нахилювача вирівняно</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>PASS</source>
            <translation>ВІДПОВІДАЄ</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>FAIL</source>
            <translation>НЕ ВІДПОВІДАЄ</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>UNDECIDED</source>
            <translation>НЕ ВИРІШЕНО</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>{angle} Error</source>
            <translation>{angle}: похибка</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Heading</source>
            <translation>Курс</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Current {angle}</source>
            <translation>{angle}: поточне</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Temperature</source>
            <translation>Температура</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/written.py" />
            <source>Verdict and tables, CSV</source>
            <translation>Рішення і таблиці, CSV</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/written.py" />
            <source>Verdict and tables, CSV with decimal comma</source>
            <translation>Рішення і таблиці, CSV з десятковою комою</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/written.py" />
            <source>Run file of the rows</source>
            <translation>Файл серії з рядками</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>{method}: {rows} accumulations, {time}; {dof} more than unknowns</source>
            <translation>{method}: {rows} [накопичення|накопичення|накопичень], {time}; на {dof} більше, ніж невідомих</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>This plan shows all that the method can tell</source>
            <translation>Цей план показує все, що може сказати метод</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>Parameter</source>
            <translation>Параметр</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>u (k = 1)</source>
            <translation>u (k = 1)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>limited by</source>
            <translation>обмежує</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>whole plan</source>
            <translation>увесь план</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>Predicted before measuring</source>
            <translation>Передбачено до вимірювання</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>From the design matrix, the noise, the settings, g</source>
            <translation>За матрицею плану, шумом, установленнями, g</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>The plan is not saved</source>
            <translation>План не збережено</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>The plan is saved: {path}</source>
            <translation>План збережено: {path}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>No tab can take this plan now</source>
            <translation>Жодна вкладка зараз не може взяти цей план</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Its test is {test}, or an accumulation is running.</source>
            <translation>Його випробування — {test}, або триває накопичення.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>End the session in its tab by New session, then open it again.</source>
            <translation>Завершіть сеанс у його вкладці через «Новий сеанс», потім відкрийте його знову.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>A plan of your own is refused</source>
            <translation>Ваш власний план відхилено</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>{title}, own {count}</source>
            <translation>{title}, власний {count}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Nothing can be predicted</source>
            <translation>Нічого передбачити не можна</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Added</source>
            <translation>Додано</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>The plans are being compared …</source>
            <translation>Плани порівнюються…</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>State the white noise N of the sensor at the left, or take it from a record.</source>
            <translation>Вкажіть ліворуч білий шум N датчика або візьміть його із запису.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>No plan measures this sensor with the tools that are ticked at the left.</source>
            <translation>Жоден план не виміряє цей датчик засобами, позначеними ліворуч.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>There is no plan that would work.</source>
            <translation>Немає плану, що працював би.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Open this plan</source>
            <translation>Відкрити цей план</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Restore all steps</source>
            <translation>Повернути всі кроки</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Nothing was changed.</source>
            <translation>Нічого не змінено.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Export</source>
            <translation>Експорт</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>{count} parameters</source>
            <translation>параметрів: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>white noise</source>
            <translation>білий шум</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>flicker, walk</source>
            <translation>флікер, блукання</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>settings</source>
            <translation>установлення</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>local g</source>
            <translation>місцеве g</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>{minutes} min</source>
            <translation>{minutes} min</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>{hours} h</source>
            <translation>{hours} h</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>{count} temperatures</source>
            <translation>температур: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/exporting.py" />
            <source>Plot, {suffix}</source>
            <translation>Графік, {suffix}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Nothing is chosen.</source>
            <translation>Нічого не вибрано.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>All that there is of it is shown here.</source>
            <translation>Усе, що про нього є, показано тут.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>The archive is being worked at.</source>
            <translation>Архів зайнятий роботою.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Open</source>
            <translation>Відкрити</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Certificate</source>
            <translation>Сертифікат</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Choose a session, a run, an old file, a record or a calibration.</source>
            <translation>Виберіть сеанс, файл вимірювання, старий файл, запис або калібрування.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Import Folder</source>
            <translation>Імпорт теки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Decode Again</source>
            <translation>Декодувати знову</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Choose a session: its raw bytes are decoded again and compared.</source>
            <translation>Виберіть сеанс: його необроблені байти буде декодовано знову і порівняно.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Refresh</source>
            <translation>Оновити</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Rebuild Index</source>
            <translation>Перебудувати індекс</translation>
        </message>
        <message>
            <location filename="../../gui/archive/exporting.py" />
            <source>Tables, CSV (1.5, …)</source>
            <translation>Таблиці, CSV (1.5, …)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/exporting.py" />
            <source>Tables, CSV (1,5; …)</source>
            <translation>Таблиці, CSV (1,5; …)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The sessions are untouched. When the cause is gone press Refresh (Ctrl+R).</source>
            <translation>Сеанси не зачеплено. Коли причину усунуто, натисніть «Оновити» (Ctrl+R).</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The archive cannot be searched</source>
            <translation>В архіві неможливо шукати</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The archive cannot be opened</source>
            <translation>Архів неможливо відкрити</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The index cannot be made</source>
            <translation>Індекс неможливо створити</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The sessions are untouched. When the cause is gone press Refresh (Ctrl+R): what is missing in the list comes back from the files.</source>
            <translation>Сеанси не зачеплено. Коли причину усунуто, натисніть «Оновити» (Ctrl+R): чого бракує у списку, повернеться з файлів.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The entry cannot be shown</source>
            <translation>Запис неможливо показати</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The list is looked up again; choose the entry once more.</source>
            <translation>Список складається знову; виберіть запис ще раз.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The history cannot be shown</source>
            <translation>Історію неможливо показати</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The folder cannot be imported</source>
            <translation>Теку неможливо імпортувати</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>What was taken in stays. Put right what is named and import the folder again: it goes on where it was broken off.</source>
            <translation>Те, що вже взято, лишається. Виправте назване і імпортуйте теку знову: імпорт продовжиться з місця, де його перервано.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The session cannot be decoded</source>
            <translation>Сеанс неможливо декодувати</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The stored means stay as they are. The raw bytes (.calrec) belong into the session's folder or into the folder raw.</source>
            <translation>Збережені середні лишаються, як були. Сирі байти (.calrec) мають лежати в теці сеансу або в теці raw.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Nothing has to be done. If it happens again, have the disk checked.</source>
            <translation>Нічого робити не треба. Якщо це повториться, перевірте диск.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Searching works as always. To measure, choose a folder that can be written to.</source>
            <translation>Пошук працює, як завжди. Щоб вимірювати, виберіть теку, в яку можна писати.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Update CalRig on this computer; until then measure as always, the newer program finds the sessions.</source>
            <translation>Оновіть CalRig на цьому комп'ютері; доти вимірюйте, як завжди: новіша програма знайде сеанси.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Open it by Load Data of the tab in which it was measured.</source>
            <translation>Відкрийте його кнопкою «Завантажити дані» тієї вкладки, де його виміряно.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>{marked} of {all} parameters differ by more than 2 u</source>
            <translation>{marked} з {all} [параметра|параметрів|параметрів] відрізняються більше ніж на 2 u</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>channel</source>
            <translation>канал</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>parameter</source>
            <translation>параметр</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>value</source>
            <translation>значення</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>unit</source>
            <translation>одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>limits</source>
            <translation>межі</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Parameters, U for 95 %</source>
            <translation>Параметри, U для 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>pass: value ± U within the limits; fail: beyond; else undecided (JCGM 106)</source>
            <translation>відповідає: значення ± U у межах; не відповідає: за межами; інакше не вирішено (JCGM 106)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>verdict</source>
            <translation>рішення</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>sensor</source>
            <translation>датчик</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>operator</source>
            <translation>оператор</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>device file</source>
            <translation>файл пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>temperature, °C</source>
            <translation>температура, °C</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>What it is</source>
            <translation>Що це</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>kind</source>
            <translation>вид</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>sensors</source>
            <translation>датчики</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>positions</source>
            <translation>положення</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>rows</source>
            <translation>рядки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>measured</source>
            <translation>виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>days later</source>
            <translation>днів потому</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Nearest calibrations by date and temperature</source>
            <translation>Найближчі калібрування за датою і температурою</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>first</source>
            <translation>перше</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>second</source>
            <translation>друге</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>d = second minus first</source>
            <translation>d = друге мінус перше</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>u² = u₁² + u₂²;  U = 2 u;  differs: |d| &gt; 2 u</source>
            <translation>u² = u₁² + u₂²;  U = 2 u;  відрізняється: |d| &gt; 2 u</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>History of {name}, {n} calibrations</source>
            <translation>Історія {name}, калібрувань: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>what</source>
            <translation>що</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>file</source>
            <translation>файл</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Files</source>
            <translation>Файли</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Import</source>
            <translation>Імпорт</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>no files</source>
            <translation>немає файлів</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>{same} of {all} positions give the same means</source>
            <translation>{same} з {all} [положення|положень|положень] дають ті самі середні</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>position</source>
            <translation>положення</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>samples</source>
            <translation>відліки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>again</source>
            <translation>знову</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>largest d / se</source>
            <translation>найбільше d / se</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Decoded again from the raw bytes</source>
            <translation>Декодовано знову з необроблених байтів</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>There is no tab {title} to open it in</source>
            <translation>Немає вкладки {title}, щоб відкрити</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>The archive</source>
            <translation>Архів</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>all temperatures</source>
            <translation>усі температури</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>{done} of {all} taken in …</source>
            <translation>взято {done} з {all}…</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>The archive is being opened …</source>
            <translation>Архів відкривається…</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>the latest {shown} of {all}</source>
            <translation>останні {shown} з {all}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>{all} found</source>
            <translation>знайдено: {all}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>Nothing is in the archive yet.

Every session and calibration of the folder of sessions comes here by itself. Import Folder (Ctrl+I) copies old files into it: those of ClbAcc, Pointer, ClbDUS and CVGCom, run files, whole sessions.</source>
            <translation>В архіві ще нічого немає.

Кожен сеанс і кожне калібрування з теки сеансів потрапляють сюди самі. «Імпорт теки» (Ctrl+I) копіює сюди старі файли: ClbAcc, Pointer, ClbDUS і CVGCom, файли серій, цілі сеанси.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>Choose an entry to see its parameters and their history; hold Ctrl and choose a second one to compare them.</source>
            <translation>Виберіть запис, щоб побачити його параметри та їх історію; утримуйте Ctrl і виберіть другий, щоб порівняти.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>There is no calibration of this device whose parameters could be followed.</source>
            <translation>Немає калібрування цього пристрою, за параметрами якого можна стежити.</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/page.py" />
            <source>Table, CSV</source>
            <translation>Таблиця, CSV</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/page.py" />
            <source>Table, CSV with decimal comma</source>
            <translation>Таблиця, CSV з десятковою комою</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/presenter.py" />
            <source>Add calibrations of gyros, runs on the rate table or on the head, and the coefficients that the Allan tab exports. Files of one unit share a column: give them the same name.</source>
            <translation>Додайте калібрування гіроскопів, серії на поворотному стенді або на головці та коефіцієнти, які експортує вкладка Аллана. Файли одного виробу ділять стовпець: дайте їм однакову назву.</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/presenter.py" />
            <source>{name} is not compared</source>
            <translation>{name} не порівнюється</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/presenter.py" />
            <source>Not compared</source>
            <translation>Не порівняно</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Gyros side by side (lab 6)</source>
            <translation>Гіроскопи поруч (лабораторна 6)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Value ± U (95 %). {star} the smallest of its row, where they can be compared.</source>
            <translation>Значення ± U (95 %). {star} найменше у своєму рядку, де їх можна порівняти.</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Quantity</source>
            <translation>Величина</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Unit</source>
            <translation>Одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>not measured</source>
            <translation>не виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source> or </source>
            <translation> або </translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>a run on the rate table</source>
            <translation>серію на поворотному стенді</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>positions on the dividing head</source>
            <translation>положення на ділильній головці</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>an Allan analysis (Export, Coefficients CSV)</source>
            <translation>аналіз Аллана (Експорт, Коефіцієнти CSV)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>{names}: no {quantity}; add {file}</source>
            <translation>{names}: немає «{quantity}»; додайте {file}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>The numbers come with the first sample of a device.</source>
            <translation>Числа з'являться з першим відліком пристрою.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Channel</source>
            <translation>Канал</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Now</source>
            <translation>Зараз</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Mean, 1 s</source>
            <translation>Середнє, 1 s</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>STD, 1 s</source>
            <translation>СКВ, 1 s</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Mean</source>
            <translation>Середнє</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Calibrated, 1 s</source>
            <translation>Калібровано, 1 s</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>The device is not stopped</source>
            <translation>Пристрій не зупинено</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>The port is closed</source>
            <translation>Порт закритий</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>The device file of {name} knows no stop command; the device goes on sending.</source>
            <translation>Файл пристрою {name} не знає команди зупинки; пристрій передає далі.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>{name} was told to stop</source>
            <translation>{name}: надіслано команду зупинки</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>Its device file knows no start command: switch it off and on to have it send again.</source>
            <translation>Його файл пристрою не знає команди запуску: вимкніть і ввімкніть його, щоб він передавав знову.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>{name} goes on sending</source>
            <translation>{name} передає далі</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>It did not obey the stop command of its device file.</source>
            <translation>Він не виконав команду зупинки зі свого файла пристрою.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>Start Device</source>
            <translation>Запустити пристрій</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Could still be added; nothing asks for it</source>
            <translation>Ще можна додати; ніщо цього не вимагає</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>How it shows</source>
            <translation>Як проявляється</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>What to do</source>
            <translation>Що робити</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>effect</source>
            <translation>ефект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>named from</source>
            <translation>помітно від</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>usual</source>
            <translation>звичайно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Smallest effects that these rows would name</source>
            <translation>Найменші ефекти, які ці рядки назвали б</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>size at which eight sigmas of the effect are visible</source>
            <translation>величина, за якої видно вісім сигм ефекту</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Looks the same in these rows</source>
            <translation>Виглядає так само в цих рядках</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>as</source>
            <translation>як</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>invisible, whatever its size</source>
            <translation>невидимий, хоч який великий</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>needs the column {name}</source>
            <translation>потребує стовпця {name}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Not to be seen in these rows</source>
            <translation>Не видно в цих рядках</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>from {size} on</source>
            <translation>від {size}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>from {size} on; usual {usual}</source>
            <translation>від {size}; звичайно {usual}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{detail}; looks the same: {others}</source>
            <translation>{detail}; так само виглядають: {others}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Fits these rows as well: {names}</source>
            <translation>До цих рядків так само підходить: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. A fault of the data</source>
            <translation>{number}. Вада даних</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. No effect explains this</source>
            <translation>{number}. Жоден ефект цього не пояснює</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. The best name, or something outside the catalogue</source>
            <translation>{number}. Найкраща назва або щось поза каталогом</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. These cannot be told apart yet</source>
            <translation>{number}. Ці поки не розрізнити</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. A term of the noise</source>
            <translation>{number}. Складова шуму</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. Missing in the model</source>
            <translation>{number}. Бракує в моделі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>evidence {nats}, {share} %</source>
            <translation>свідчення {nats}, {share} %</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>gap {gap}</source>
            <translation>розбіжність {gap}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{count} positions, {minutes} min</source>
            <translation>положень: {count}, {minutes} min</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{count} rates, {minutes} min</source>
            <translation>швидкостей: {count}, {minutes} хв</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{why}. Tells apart: {names}.</source>
            <translation>{why}. Розрізняє: {names}.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>a fault of the data, counted in them</source>
            <translation>вада даних, порахована в них</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>no effect of the catalogue fits</source>
            <translation>жоден ефект каталогу не підходить</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>at the best roughly: {names}</source>
            <translation>хіба що приблизно: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>a term of the noise, no fault</source>
            <translation>складова шуму, не несправність</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>no other name fits</source>
            <translation>жодна інша назва не підходить</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>but could also be something outside the catalogue</source>
            <translation>але може бути й чимось поза каталогом</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>but could also be {names}, or something outside the catalogue</source>
            <translation>але може бути й {names} або щось поза каталогом</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>but could also be {names}</source>
            <translation>але може бути й {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>{names} and {count} further names</source>
            <translation>{names} та ще назв: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Report, PDF</source>
            <translation>Звіт, PDF</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Report, HTML</source>
            <translation>Звіт, HTML</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Results, JSON</source>
            <translation>Результати, JSON</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Model, JSON</source>
            <translation>Модель, JSON</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>A session holds another plan, or an accumulation is running.</source>
            <translation>Сеанс тримає інший план, або триває накопичення.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>The plan is not kept</source>
            <translation>План не збережено</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>The plan is kept</source>
            <translation>План збережено</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>{path}: after the next start it stands among the plans of its tab.</source>
            <translation>{path}: після наступного запуску він буде серед планів своєї вкладки.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>Plain model</source>
            <translation>Проста модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>{sigmas} σ at {value}</source>
            <translation>{sigmas} σ при {value}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>χ²/ν {value}</source>
            <translation>χ²/ν {value}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>held out {value}</source>
            <translation>вилучені {value}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>evidence {value}</source>
            <translation>свідчення {value}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>from replicates</source>
            <translation>з повторень</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>from standard errors</source>
            <translation>зі стандартних похибок</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>from the residuals</source>
            <translation>із залишків</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>noise floor {size} {unit}, {source}</source>
            <translation>рівень шуму {size} {unit}, {source}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>{device}: {rows} samples</source>
            <translation>{device}: відліків {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>{device}: {rows} rows</source>
            <translation>{device}: рядків {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>{device}: {rows} rows × {count} outputs</source>
            <translation>{device}: рядків {rows} × виходів {count}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Look at the residuals, and answer on the page Practice.</source>
            <translation>Перегляньте залишки й дайте відповідь на сторінці «Вправа».</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Record for longer.</source>
            <translation>Записуйте довше.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Measure more positions, and each twice; then load both files together.</source>
            <translation>Виміряйте більше положень, кожне двічі; потім завантажте обидва файли разом.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Find (Space) looks for the reason.</source>
            <translation>«Знайти» (Space) шукає причину.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Find (Space) looks closer.</source>
            <translation>«Знайти» (Space) придивляється пильніше.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Nothing to add. “What can be seen” tells how small an effect would have been named.</source>
            <translation>Додавати нічого. «Що можна побачити» каже, який малий ефект було б названо.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Measure once more: noise goes another way then, a cause does not.</source>
            <translation>Виміряйте ще раз: шум тоді піде інакше, причина — ні.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Measure next: {title}, {minutes} min; it decides with {chance} %. Then load both files together.</source>
            <translation>Виміряйте далі: {title}, {minutes} хв; вирішить на {chance} %. Потім завантажте обидва файли разом.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Record next: {title}, {minutes} min; it decides with {chance} %.</source>
            <translation>Запишіть далі: {title}, {minutes} хв; вирішить на {chance} %.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Look at rig and sensor where the curve is largest, and measure more densely there.</source>
            <translation>Огляньте стенд і давач там, де крива найбільша, і виміряйте там густіше.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>No series that was tried would decide; only knowledge from elsewhere can.</source>
            <translation>Жодна з перевірених серій не вирішила б; може лише знання з іншого джерела.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Add to Model (Ctrl+Return); a new series then confirms the name.</source>
            <translation>«Додати до моделі» (Ctrl+Return); назву потім підтвердить нова серія.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Report (Ctrl+E); a second record confirms the name.</source>
            <translation>«Звіт» (Ctrl+E); назву підтвердить другий запис.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Use in Calibration (F7); a new series with other angles or order confirms the name.</source>
            <translation>«До калібрування» (F7); назву підтвердить нова серія з іншими кутами чи порядком.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/picture.py" />
            <source>{name}: what the effects so far leave, largest {place}</source>
            <translation>{name}: що лишають додані ефекти, найбільше {place}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/picture.py" />
            <source>{name}: structure beyond the noise, {p}, largest {place}</source>
            <translation>{name}: структура понад шум, {p}, найбільше {place}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/picture.py" />
            <source>{name}: no structure beyond the noise, {p}, largest {place}</source>
            <translation>{name}: структури понад шум немає, {p}, найбільше {place}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/presenter.py" />
            <source>No tab calibrates this run</source>
            <translation>Жодна вкладка не калібрує за цим вимірюванням</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/presenter.py" />
            <source>Model and data cannot be compared</source>
            <translation>Модель і дані неможливо порівняти</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Model vs data: {device}</source>
            <translation>Модель і дані: {device}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>The ladder</source>
            <translation>Драбина</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>times the noise floor; 1 is the best</source>
            <translation>рівнів шуму; найкраще — 1</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>model</source>
            <translation>модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>gap</source>
            <translation>розбіжність</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>held out</source>
            <translation>вилучені</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>rms, {unit}</source>
            <translation>СКВ, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>gap: rms of the whitened residuals; 1 (dotted) is the noise floor, {size} {unit} rms; the stroke: the gap of rows that were left out of the fit</source>
            <translation>розбіжність: СКВ вибілених залишків; 1 (пунктир) — рівень шуму, {size} {unit} СКВ; риска: розбіжність рядків, вилучених з оцінки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Residual with the effects added</source>
            <translation>Залишок з доданими ефектами</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Residual of the plain model</source>
            <translation>Залишок простої моделі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Points: rows. Line: their smooth structure. Band: where all means of a right model stay (95 %); those that leave it are diamonds, and their stretches are tinted.</source>
            <translation>Точки: рядки. Лінія: їх гладка структура. Смуга: де лишаються всі середні правильної моделі (95 %); ті, що виходять з неї, — ромби, а їх ділянки затінено.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>evidence {evidence} nats, probability {share} among the names, {p}</source>
            <translation>свідчення {evidence} nats, імовірність {share} серед назв, {p}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Cannot be told from: {names}</source>
            <translation>Не відрізнити від: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>regressor</source>
            <translation>регресор</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>before</source>
            <translation>до</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>largest</source>
            <translation>найбільша</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>after</source>
            <translation>після</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Where the residual has structure</source>
            <translation>Де залишок має структуру</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>p adjusted for all regressors together (Westfall and Young)</source>
            <translation>p з поправкою на всі регресори разом (Вестфолл і Янг)</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>series</source>
            <translation>серія</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>why</source>
            <translation>чому</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>effort</source>
            <translation>зусилля</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>decides, %</source>
            <translation>вирішує, %</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>What to measure next</source>
            <translation>Що виміряти далі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>There is nothing to compare yet.</source>
            <translation>Порівнювати ще нічого.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Nothing was measured yet.</source>
            <translation>Ще нічого не виміряно.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>The case is sealed: answer first.</source>
            <translation>Випадок запечатано: спершу дайте відповідь.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Find proposes effects first.</source>
            <translation>Спершу «Знайти» пропонує ефекти.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Find</source>
            <translation>Знайти</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Add to Model</source>
            <translation>Додати до моделі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Add All</source>
            <translation>Додати всі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Undo</source>
            <translation>Скасувати</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Nothing was added.</source>
            <translation>Нічого не додано.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Simulate with This Model</source>
            <translation>Симулювати</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Hide Simulation</source>
            <translation>Без симуляції</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Use in Calibration</source>
            <translation>До калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Load Data</source>
            <translation>Завантажити дані</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Report</source>
            <translation>Звіт</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Practice</source>
            <translation>Вправа</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>A sealed case</source>
            <translation>Запечатаний випадок</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>The plain model is rejected</source>
            <translation>Просту модель відхилено</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>No regressor speaks against the plain model</source>
            <translation>Жоден регресор не свідчить проти простої моделі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>This plan can show nothing</source>
            <translation>Цей план не може показати нічого</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Its rows leave nothing that could contradict the plain model: measure more positions, and each twice.</source>
            <translation>Його рядки не лишають нічого, що могло б суперечити простій моделі: виміряйте більше положень, і кожне двічі.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>What this plan can show</source>
            <translation>Що може показати цей план</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>{alone} effects by themselves, {tied} only together with others, {hidden} not at all; for usual sensors on a usual head or table.</source>
            <translation>Ефектів окремо: {alone}, лише разом з іншими: {tied}, зовсім ні: {hidden}; для звичайних датчиків на звичайній головці чи стенді.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Load Data (Ctrl+O) takes a session's folder, run files, records or text files of the old programs; several of one unit are compared as one run.

Find (Space) then looks for what the model lacks, names it, and says how sure that is; or press “Model vs data” on a page of results.

Practice (F8) hides something in rows of the simulated rig, for you to name.</source>
            <translation>«Завантажити дані» (Ctrl+O) бере теку сеансу, файли вимірювань, записи або текстові файли старих програм; кілька файлів одного виробу порівнюються як одне вимірювання.

«Знайти» (Space) тоді шукає, чого бракує моделі, називає це і каже, наскільки це певно; або натисніть «Модель і дані» на сторінці результатів.

«Вправа» (F8) ховає щось у рядках імітованого стенда, щоб назвали ви.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Case {number}</source>
            <translation>Випадок {number}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>correct</source>
            <translation>правильно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>not correct</source>
            <translation>неправильно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Step {number} of the program: {names}</source>
            <translation>Крок {number} програми: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Hidden: {names}</source>
            <translation>Приховано: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>You: {names} ({verdict})</source>
            <translation>Ви: {names} ({verdict})</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Program: {count} named ({verdict})</source>
            <translation>Програма: названо {count} ({verdict})</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>The seal is the SHA-256 of this text: {key}</source>
            <translation>Печатка — це SHA-256 такого тексту: {key}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>No case was opened yet.</source>
            <translation>Жодного випадку ще не відкрито.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Of {cases} cases you had {operator} right, the program {program}.</source>
            <translation>З {cases} [випадку|випадків|випадків] ви вгадали {operator}, програма — {program}.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>accelerometer on the dividing head</source>
            <translation>акселерометр на ділильній головці</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>gyro on the rate table</source>
            <translation>гіроскоп на поворотному стенді</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>gyro at rest on the head</source>
            <translation>нерухомий гіроскоп на головці</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>record of a vibratory gyro</source>
            <translation>запис вібраційного гіроскопа</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>nothing is missing</source>
            <translation>нічого не бракує</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Reading the rows …</source>
            <translation>Читання рядків…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Walking the plan with usual sensors …</source>
            <translation>Проходження плану зі звичайними датчиками …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Measuring a sealed case …</source>
            <translation>Вимірювання запечатаного випадку …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Estimating the noise floor …</source>
            <translation>Оцінювання рівня шуму…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Looking where the residuals are …</source>
            <translation>Пошук, де лежать залишки…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Trying all effects, also in sets …</source>
            <translation>Перевірка всіх ефектів, також наборами…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Fitting what was found, and what could decide …</source>
            <translation>Оцінювання знайденого і того, що могло б вирішити…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Fitting the model with the effect …</source>
            <translation>Оцінювання моделі з ефектом…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Walking the rows on the simulated rig …</source>
            <translation>Проходження рядків на імітованому стенді…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>The model explains the data</source>
            <translation>Модель пояснює дані</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>An effect is missing, and named</source>
            <translation>Бракує ефекту, його названо</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>An effect is missing; several names fit</source>
            <translation>Бракує ефекту; підходить кілька назв</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Structure that no effect explains</source>
            <translation>Структура, якої не пояснює жоден ефект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>More noise than is stated</source>
            <translation>Шуму більше, ніж указано</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>The data are at fault</source>
            <translation>Винні дані</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Too few rows to tell</source>
            <translation>Замало рядків для відповіді</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Model and data agree now</source>
            <translation>Модель і дані тепер збігаються</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>They agree now; several names fit</source>
            <translation>Тепер збігаються; підходить кілька назв</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Head angle</source>
            <translation>Кут головки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Set rate</source>
            <translation>Задана швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>a_x along case X</source>
            <translation>a_x уздовж X корпусу</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>a_y along case Y</source>
            <translation>a_y уздовж Y корпусу</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>a_z along case Z</source>
            <translation>a_z уздовж Z корпусу</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Order of measuring</source>
            <translation>Порядок вимірювання</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Time</source>
            <translation>Час</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Time since the mounting</source>
            <translation>Час від встановлення</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Rate of temperature</source>
            <translation>Швидкість зміни температури</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Position, number</source>
            <translation>Положення, номер</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Mounting, number</source>
            <translation>Встановлення, номер</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Pass of the plan</source>
            <translation>Прохід плану</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Direction of approach</source>
            <translation>Напрям підходу</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Setting before</source>
            <translation>Попередня уставка</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Output</source>
            <translation>Вихід</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Frequency</source>
            <translation>Частота</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Unexplained structure</source>
            <translation>Непояснена структура</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>The gap goes from {before} to {after} noise floors.</source>
            <translation>Розбіжність зменшується з {before} до {after} рівнів шуму.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>No effect stands out of the noise.</source>
            <translation>Жоден ефект не виступає з шуму.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>{named}. {closing}</source>
            <translation>{named}. {closing}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>The session went through {count} temperatures</source>
            <translation>Сеанс пройшов через {count} температур</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>Process Data takes one temperature at a time; the Thermal tab takes them together: bias and scale factor against temperature, hysteresis.</source>
            <translation>«Обробити дані» бере по одній температурі; вкладка «Термо» бере їх разом: зміщення нуля і масштабний коефіцієнт за температурою, гістерезис.</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>Open in Thermal</source>
            <translation>Відкрити в «Термо»</translation>
        </message>
        <message>
            <location filename="../../gui/drift/exporting.py" />
            <source>Plots, {suffix}</source>
            <translation>Графіки, {suffix}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>{p} knots × {m} temperatures, {bytes} bytes</source>
            <translation>{p} [вузол|вузли|вузлів] × {m} [температура|температури|температур], {bytes} [байт|байти|байтів]</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source> of {memory}</source>
            <translation> з {memory}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>{n} turn-ons, {low} … {high}; from {start} to {stop} s. The start is brought to zero over {begin} … {end} s, whose noise u = {noise} {unit} every correction carries.</source>
            <translation>{n} [увімкнення|увімкнення|увімкнень], {low} … {high}; від {start} до {stop} s. Початок зведено до нуля за {begin} … {end} s; шум цього u = {noise} {unit} несе кожна корекція.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>No table</source>
            <translation>Таблиці немає</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Left on turn-ons that were not seen</source>
            <translation>Залишається на не бачених увімкненнях</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Each turn-on is left out in turn and corrected by what the others gave; rms of block means.</source>
            <translation>Кожне увімкнення по черзі вилучено і виправлено за тим, що дали інші; СКВ середніх по блоках.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>× table</source>
            <translation>× таблиця</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>bytes</source>
            <translation>байти</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>knot</source>
            <translation>вузол</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>t, s</source>
            <translation>t, s</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>The table</source>
            <translation>Таблиця</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Linear between knots and, by values, between temperatures of the chip.</source>
            <translation>Лінійно між вузлами і, за значеннями, між температурами кристала.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Temperature nodes, rms in {unit}</source>
            <translation>Температурні вузли, СКВ в {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Without the node: its turn-ons corrected by values interpolated between its neighbours. Much more than with it means that the nodes are too far apart.</source>
            <translation>Без вузла: його увімкнення виправлено значеннями, інтерпольованими між сусідами. Значно більше, ніж з ним, означає, що вузли задалекі.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>chip</source>
            <translation>кристал</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>turn-ons</source>
            <translation>увімкнення</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>none</source>
            <translation>немає</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>quartic</source>
            <translation>четвертий степінь</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>table</source>
            <translation>таблиця</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>without node</source>
            <translation>без вузла</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>By number of knots</source>
            <translation>За кількістю вузлів</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>The fewest that leave at most 2 % more than the best are taken.</source>
            <translation>Береться найменша, що залишає щонайбільше на 2 % більше за найкращу.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>tp</source>
            <translation>tp</translation>
        </message>
        <message>
            <location filename="../../gui/drift/picture.py" />
            <source>cost {cost} {unit} rms on the means (optimal {best}), {p} knots, {bytes} bytes</source>
            <translation>ціна {cost} {unit} СКВ на середніх (оптимум {best}), {p} [вузол|вузли|вузлів], {bytes} [байт|байти|байтів]</translation>
        </message>
        <message>
            <location filename="../../gui/drift/picture.py" />
            <source>mean</source>
            <translation>середнє</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>{name} is no turn-on</source>
            <translation>{name} не є увімкненням</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Remove it from the list, or choose another output at the left.</source>
            <translation>Приберіть його зі списку або виберіть інший вихід ліворуч.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Simulated gyro</source>
            <translation>Симульований гіроскоп</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>is being read …</source>
            <translation>читається…</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>1 turn-on</source>
            <translation>1 увімкнення</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>{n} turn-ons</source>
            <translation>увімкнень: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>{seconds} s</source>
            <translation>{seconds} s</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>All temperatures</source>
            <translation>Усі температури</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>There is no table yet.</source>
            <translation>Таблиці ще немає.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>The knots stand where the search put them.</source>
            <translation>Вузли стоять там, де їх поставив пошук.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Add Turn-ons</source>
            <translation>Додати увімкнення</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Add Folder</source>
            <translation>Додати теку</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Simulated turn-ons</source>
            <translation>Симуляція</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Optimal knots</source>
            <translation>Оптимальні вузли</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Remove</source>
            <translation>Прибрати</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>None is chosen.</source>
            <translation>Нічого не вибрано.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>The turn-ons are being read …</source>
            <translation>Увімкнення читаються…</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Add Turn-ons (Ctrl+O) reads records that began with switching on: recordings, files of CVGCom, run files, columns of numbers. About five at each temperature, at least 5 minutes apart so that the unit cools down.

Simulated turn-ons (F6) shows the tab on a made-up gyro.</source>
            <translation>«Додати увімкнення» (Ctrl+O) читає записи, що почалися з увімкнення: записи програми, файли CVGCom, файли серій, стовпці чисел. Близько п'яти за кожної температури, з перервою щонайменше 5 хвилин, щоб виріб охолов.

«Симульовані увімкнення» (F6) показує вкладку на вигаданому гіроскопі.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>no correction</source>
            <translation>без корекції</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>cubic in time</source>
            <translation>куб часу</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>quartic in time</source>
            <translation>четвертий степінь часу</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>sharpest angles (003)</source>
            <translation>найгостріші кути (003)</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>this table</source>
            <translation>ця таблиця</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>mean curve (floor)</source>
            <translation>середня крива (дно)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Planned seeking</source>
            <translation>Заплановане визначення</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>{file}: {rows} readings</source>
            <translation>{file}: показів {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Heading at 0</source>
            <translation>Курс при 0</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Drift</source>
            <translation>Дрейф</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Earth, level part</source>
            <translation>Земля, горизонтальна складова</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>  by the latitude</source>
            <translation>  за широтою</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Change of the drift</source>
            <translation>Зміна дрейфу</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Heading and drift</source>
            <translation>Курс і дрейф</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Value</source>
            <translation>Значення</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>As set</source>
            <translation>Як задано</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Best</source>
            <translation>Найкраще</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Enough for {target}°</source>
            <translation>Досить для {target}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>never with this gyro</source>
            <translation>ніколи з цим гіроскопом</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>u of the heading: {count} headings, {pause} s to turn, by N, B, K</source>
            <translation>u курсу: {count} [курс|курси|курсів], {pause} s на поворот, за N, B, K</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>How long to average</source>
            <translation>Як довго усереднювати</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>time, s</source>
            <translation>час, s</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Kept afterwards by the same gyro</source>
            <translation>Утримання потім тим самим гіроскопом</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Its drift, as found, is subtracted</source>
            <translation>Його дрейф, як знайдено, віднято</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>for, h</source>
            <translation>протягом, h</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/page.py" />
            <source>Measurements (*.csv *.txt *.json *.jsonl)</source>
            <translation>Вимірювання (*.csv *.txt *.json *.jsonl)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/page.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>The file is refused</source>
            <translation>Файл відхилено</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>The run is being read …</source>
            <translation>Серія читається…</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>Heading from the rotation of the Earth, by one gyro turned on a level base.

Load Data (Ctrl+O) reads a run of headings: column head_deg is the reading of the base, clockwise; tilt_deg the elevation of the input axis by an accelerometer.

State the noise of the gyro at the left, or take it from a record, to see how long to average.</source>
            <translation>Курс за обертанням Землі одним гіроскопом, що повертається на горизонтальній основі.

«Завантажити дані» (Ctrl+O) читає серію курсів: стовпець head_deg — показ основи за годинниковою стрілкою; tilt_deg — кут піднесення вхідної осі за акселерометром.

Вкажіть ліворуч шум гіроскопа або візьміть його із запису, щоб побачити, як довго усереднювати.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>There is nothing to export yet.</source>
            <translation>Експортувати ще нічого.</translation>
        </message>
        <message>
            <location filename="../../gui/keys/key_html.py" />
            <source>Keys of CalRig</source>
            <translation>Клавіші CalRig</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Stop the accumulation</source>
            <translation>Зупинити накопичення</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Take the last one back</source>
            <translation>Скасувати останнє</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Stop the record</source>
            <translation>Зупинити запис</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Stop the live curve</source>
            <translation>Зупинити живу криву</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Hands-free</source>
            <translation>Без рук</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Search</source>
            <translation>Пошук</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Show the log</source>
            <translation>Показати журнал</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Device Properties</source>
            <translation>Властивості пристроїв</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>OK</source>
            <translation>OK</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Close</source>
            <translation>Закрити</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Distance view</source>
            <translation>Вигляд здалеку</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Leave it</source>
            <translation>Залишити його</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>List of steps</source>
            <translation>Список кроків</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Look at another step</source>
            <translation>Переглянути інший крок</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Make it the current step</source>
            <translation>Зробити його поточним</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Pick a step by its place</source>
            <translation>Вибрати крок за місцем</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Charts over time</source>
            <translation>Графіки за часом</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Move in time</source>
            <translation>Рух у часі</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Zoom in and out</source>
            <translation>Збільшити і зменшити</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Show everything</source>
            <translation>Показати все</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Follow the newest samples</source>
            <translation>Стежити за найновішими відліками</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Other channels</source>
            <translation>Інші канали</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Set a cursor at the pointer</source>
            <translation>Поставити курсор біля вказівника</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Move the cursor by a sample</source>
            <translation>Посунути курсор на відлік</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Clear the cursors</source>
            <translation>Прибрати курсори</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Plots</source>
            <translation>Графіки</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Allan plot</source>
            <translation>Графік Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Read the curve by points</source>
            <translation>Читати криву по точках</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Plot of the drift table</source>
            <translation>Графік таблиці дрейфу</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Choose a knot</source>
            <translation>Вибрати вузол</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Move the knot</source>
            <translation>Посунути вузол</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Matrices, tables, log</source>
            <translation>Матриці, таблиці, журнал</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Copy</source>
            <translation>Копіювати</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Table of means</source>
            <translation>Таблиця середніх</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Paste a column of references</source>
            <translation>Вставити стовпець заданих значень</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Dial of the simulated rig</source>
            <translation>Шкала симульованого стенда</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn by a step</source>
            <translation>Повернути на крок</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn by a fine step</source>
            <translation>Повернути на дрібний крок</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn by a quarter</source>
            <translation>Повернути на чверть</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn to zero</source>
            <translation>Повернути до нуля</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Preferences</source>
            <translation>Налаштування</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Candidates</source>
            <translation>Кандидати</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Choose it</source>
            <translation>Вибрати його</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Bytes of a board</source>
            <translation>Байти плати</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Point at another byte</source>
            <translation>Вказати на інший байт</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Select bytes</source>
            <translation>Вибрати байти</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Add a field</source>
            <translation>Додати поле</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Remove the field</source>
            <translation>Прибрати поле</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Preview of a certificate</source>
            <translation>Перегляд сертифіката</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn the page</source>
            <translation>Перегорнути сторінку</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Tour</source>
            <translation>Огляд</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Go on</source>
            <translation>Далі</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Message</source>
            <translation>Повідомлення</translation>
        </message>
        <message>
            <location filename="../../gui/keys/sheet.py" />
            <source>Everywhere</source>
            <translation>Усюди</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Click into the charts for cursor A, Shift+click for B.</source>
            <translation>Клацніть по графіках для курсора A, Shift+клацання — для B.</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Between the cursors</source>
            <translation>Між курсорами</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source> So were {n} others.</source>
            <translation> Так само ще {n}.</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>A record was interrupted: {name}</source>
            <translation>Запис було перервано: {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>The program or the computer stopped while it ran.{more}</source>
            <translation>Програма або комп'ютер зупинилися під час запису.{more}</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>All up to about a second before stands in it; START begins the next record.</source>
            <translation>У ньому є все, крім приблизно останньої секунди; START починає наступний запис.</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>Open it</source>
            <translation>Відкрити його</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>The means are not handed over</source>
            <translation>Середні не передано</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Rate table</source>
            <translation>Поворотний стенд</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Dividing head</source>
            <translation>Ділильна головка</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Run file written</source>
            <translation>Файл серії записано</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Load Data of the tab {tab} takes it.</source>
            <translation>Його приймає «Завантажити дані» вкладки {tab}.</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>set rate</source>
            <translation>задана швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>has no {what} yet</source>
            <translation>ще не має {what}</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Set rate, °/s</source>
            <translation>Задана швидкість, °/s</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Mount:angle</source>
            <translation>Встановлення:кут</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Record</source>
            <translation>Запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>No samples: choose a device, or load a record</source>
            <translation>Немає відліків: виберіть пристрій або завантажте запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Watching, not recorded</source>
            <translation>Спостереження, не записується</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Recording {name}</source>
            <translation>Записується {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Stopped: {name}</source>
            <translation>Зупинено: {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Record {name}</source>
            <translation>Запис {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>No device sends samples, or their rate is not known yet</source>
            <translation>Жоден пристрій не передає відліків, або їх частота ще невідома</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>START sampling process</source>
            <translation>Почати запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>STOP sampling process</source>
            <translation>Зупинити запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>A record is running</source>
            <translation>Триває запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>No record is stopped</source>
            <translation>Жоден запис не зупинено</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Resume</source>
            <translation>Продовжити</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Discard</source>
            <translation>Відкинути</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Live view</source>
            <translation>Живий вигляд</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>The live view is on the screen</source>
            <translation>Живий вигляд уже на екрані</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Load record</source>
            <translation>Завантажити запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Nothing is on the screen</source>
            <translation>На екрані нічого немає</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Record stopped</source>
            <translation>Запис зупинено</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>{name}: {count} samples, {seconds} s, safe on the disk.</source>
            <translation>{name}: {count} [відлік|відліки|відліків], {seconds} s, надійно на диску.</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>START begins another one.</source>
            <translation>START починає наступний.</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>The disk lasts {time} more</source>
            <translation>Диска вистачить ще на {time}</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{folder} has little room left for the record.</source>
            <translation>{folder}: мало місця для запису.</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>Free some space; what is written stays readable when it runs out.</source>
            <translation>Звільніть місце; записане лишається читабельним, коли воно закінчиться.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Accumulates by itself once the table turns steadily.</source>
            <translation>Накопичує сам, коли стенд обертається рівномірно.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>The rate is changing.</source>
            <translation>Швидкість змінюється.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>The table turns steadily; hands off.</source>
            <translation>Стенд обертається рівномірно; не торкайтеся.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Leave the table alone.</source>
            <translation>Не чіпайте стенд.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>The rate changed</source>
            <translation>Швидкість змінилася</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Wrong rate</source>
            <translation>Неправильна швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Rates</source>
            <translation>Швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Stop the table</source>
            <translation>Зупиніть стенд</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Turn at {rate}</source>
            <translation>Задайте {rate}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Stop the table and bolt the unit on with {up}. </source>
            <translation>Зупиніть стенд і закріпіть виріб: {up}. </translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>counter-clockwise seen from above</source>
            <translation>проти годинникової, якщо зверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>clockwise seen from above</source>
            <translation>за годинниковою, якщо зверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>{seconds} s (whole turns: {turns})</source>
            <translation>{seconds} s (цілих обертів: {turns})</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>{seconds} s ({turns} turns; {whole} s would be whole turns)</source>
            <translation>{seconds} s ({turns} [оберт|оберти|обертів]; цілими були б {whole} s)</translation>
        </message>
        <message>
            <location filename="../../gui/report_export.py" />
            <source>Tables, CSV</source>
            <translation>Таблиці, CSV</translation>
        </message>
        <message>
            <location filename="../../gui/report_export.py" />
            <source>Picture, {suffix}</source>
            <translation>Малюнок, {suffix}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Nothing found</source>
            <translation>Нічого не знайдено</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>{rows} positions, {device}</source>
            <translation>положень: {rows}, {device}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>, {low} … {high}; beyond, nothing is compensated</source>
            <translation>, {low} … {high}; поза цим нічого не компенсується</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Six positions and temperature</source>
            <translation>Шість положень і температура</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Parameters over temperature</source>
            <translation>Параметри за температурою</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>{channel}: U0, {unit}</source>
            <translation>{channel}: U0, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>at</source>
            <translation>при</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Hysteresis: heating less cooling, 95 %</source>
            <translation>Гістерезис: нагрівання мінус охолодження, 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>What no function of the temperature can compensate.</source>
            <translation>Чого не скомпенсує жодна функція температури.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>U0 / k</source>
            <translation>U0 / k</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Orders, rms at temperatures left out</source>
            <translation>Порядки, СКВ за вилучених температур</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>The lowest that leave at most 10 % more than the best are taken.</source>
            <translation>Береться найнижчий, що залишає щонайбільше на 10 % більше за найкращий.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>took part</source>
            <translation>брав участь</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>all</source>
            <translation>усі</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Rows of the check run, which took no part.</source>
            <translation>Рядки перевірної серії, що не брала участі.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Each temperature but the outermost is left out in turn and compensated by the others.</source>
            <translation>Кожну температуру, крім крайніх, по черзі вилучено і скомпенсовано за іншими.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Largest error of roll or pitch, °</source>
            <translation>Найбільша похибка крену або тангажу, °</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>compensated</source>
            <translation>скомпенсовано</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Errors of roll and pitch, °</source>
            <translation>Похибки крену і тангажу, °</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Roll is not defined where the Y axis is vertical.</source>
            <translation>Крен не визначений там, де вісь Y вертикальна.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>roll</source>
            <translation>крен</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>pitch</source>
            <translation>тангаж</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>roll before</source>
            <translation>крен до</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>pitch before</source>
            <translation>тангаж до</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>roll after</source>
            <translation>крен після</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>pitch after</source>
            <translation>тангаж після</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>left, {axis}</source>
            <translation>залишок, {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Six positions</source>
            <translation>Шість положень</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Six positions at {t}</source>
            <translation>Шість положень при {t}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>{law}: scale factors, angles of T, mounting. Nine: source 002 has no R.</source>
            <translation>{law}: масштабні коефіцієнти, кути T, встановлення. Дев'ять: джерело 002 не має R.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>twelve</source>
            <translation>дванадцять</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>nine</source>
            <translation>дев'ять</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>left, twelve</source>
            <translation>залишок, дванадцять</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>left, nine</source>
            <translation>залишок, дев'ять</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>The same at each temperature</source>
            <translation>Те саме за кожної температури</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>↑ reached by heating, ↓ by cooling.</source>
            <translation>↑ досягнуто нагріванням, ↓ охолодженням.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>polynomial</source>
            <translation>поліном</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>cycle</source>
            <translation>цикл</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>U0, {unit}</source>
            <translation>U0, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>k, {unit}</source>
            <translation>k, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>{channel}, order {order}</source>
            <translation>{channel}, порядок {order}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>{title};  hysteresis {value} {unit} at {at}</source>
            <translation>{title};  гістерезис {value} {unit} при {at}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>heated</source>
            <translation>нагрівання</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>cooled</source>
            <translation>охолодження</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>by the first temperature</source>
            <translation>за першою температурою</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>error, °</source>
            <translation>похибка, °</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>heating</source>
            <translation>нагрівання</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>cooling</source>
            <translation>охолодження</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Outputs</source>
            <translation>Виходи</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>There is no cycle yet</source>
            <translation>Циклу ще немає</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>In {root} no session of the dividing head went through temperatures.</source>
            <translation>У {root} жоден сеанс ділильної головки не проходив температур.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Measure one there (Temperatures), or add its files here.</source>
            <translation>Виміряйте його там (Температури) або додайте його файли тут.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>The last cycle was not found</source>
            <translation>Останнього циклу не знайдено</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>{name} cannot be used</source>
            <translation>{name} неможливо використати</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Remove it from the list; the others are used without it.</source>
            <translation>Приберіть його зі списку; інші використовуються без нього.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Simulated cycle</source>
            <translation>Симуляція</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>{rows} rows</source>
            <translation>рядків: {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>check only</source>
            <translation>лише перевірка</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Last Cycle</source>
            <translation>Останній цикл</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Add Files</source>
            <translation>Додати файли</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Check only</source>
            <translation>Лише перевірка</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Let take part</source>
            <translation>Дозволити участь</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>The files are being read …</source>
            <translation>Файли читаються…</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>There is nothing to draw over the temperature; see the notes.</source>
            <translation>За температурою малювати нічого; див. примітки.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Last Cycle (Space) takes the newest session that the dividing head measured through its Temperatures (+27 −10 −40 −10 +27 +50 +70 +50 +27 °C).

Add Files or Add Folder takes sessions, run files and ClbAcc's text files as one set, or the record of a unit that stood in the chamber.

Simulated cycle (F6) shows the tab on a made-up unit.</source>
            <translation>«Останній цикл» (Space) бере найновіший сеанс, який ділильна головка виміряла через свої температури (+27 −10 −40 −10 +27 +50 +70 +50 +27 °C).

«Додати файли» або «Додати теку» бере сеанси, файли серій і текстові файли ClbAcc як один набір або запис виробу, що стояв у камері.

«Симульований цикл» (F6) показує вкладку на вигаданому виробі.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>{rows} rows, {device}, {low} … {high}; beyond, nothing is compensated</source>
            <translation>{rows} [рядок|рядки|рядків], {device}, {low} … {high}; поза цим нічого не компенсується</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>A standing unit over temperature</source>
            <translation>Нерухомий виріб за температурою</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>Before and after, {unit}</source>
            <translation>До і після, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>Heating less cooling where they differ most, 95 %.</source>
            <translation>Нагрівання мінус охолодження там, де вони різняться найбільше, 95 %.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>output</source>
            <translation>вихід</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>order</source>
            <translation>порядок</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>sd before</source>
            <translation>СКВ до</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>hysteresis</source>
            <translation>гістерезис</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>Polynomials</source>
            <translation>Поліноми</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>coefficient</source>
            <translation>коефіцієнт</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/texts.py" />
            <source>Bias</source>
            <translation>Зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/texts.py" />
            <source>Scale factor</source>
            <translation>Масштаб. коеф.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/texts.py" />
            <source>Errors of roll and pitch</source>
            <translation>Похибки крену і тангажу</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The device</source>
            <translation>Пристрій</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>A simulated sensor unit is connected; a real one is found by Properties, Scan. This line tells whether samples come, how fast, and whether any are bad or lost.</source>
            <translation>Під'єднано симульований блок датчиків; справжній знаходять через «Властивості», «Пошук». Цей рядок каже, чи надходять відліки, як швидко, і чи є хибні або втрачені.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The plan</source>
            <translation>План</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Every position that this test wants, with its picture. The marked one is next; a click, a digit, or the arrows and Enter pick another.</source>
            <translation>Кожне положення, потрібне цьому випробуванню, з рисунком. Позначене — наступне; клацання, цифра або стрілки й Enter вибирають інше.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>What to do now</source>
            <translation>Що робити зараз</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The order of the moment in large letters: turn, wait, measuring, done. F11 gives it the whole screen, so that it is read from the dividing head.</source>
            <translation>Наказ моменту великими літерами: повернути, чекати, вимірювання, готово. F11 дає йому весь екран, щоб читати від ділильної головки.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The simulated rig</source>
            <translation>Симульований стенд</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Drag the hand of the dial, or let Operator turns it for me do it. Faults can be tried as well: unplug the cable, and see that nothing is lost.</source>
            <translation>Потягніть стрілку шкали або дайте «Оператор повертає за мене» зробити це. Можна випробувати й несправності: від'єднайте кабель і побачите, що нічого не втрачено.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Measuring</source>
            <translation>Вимірюю</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Space accumulates, here and in every tab. Backspace repeats the last position, Ctrl+Z takes it back, Esc stops. Switch Hands-free on, and a turned and resting head is enough. At the end Process Data (F5), then Export.</source>
            <translation>Space накопичує, тут і в кожній вкладці. Backspace повторює останнє положення, Ctrl+Z скасовує його, Esc зупиняє. Увімкніть «Без рук», і досить повернути головку та зачекати. Наприкінці «Обробити дані» (F5), потім «Експорт».</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Settings of the test</source>
            <translation>Налаштування випробування</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Times, local gravity and its uncertainty, uncertainty of the head. What holds for the whole laboratory stands in Preferences (Ctrl+,).</source>
            <translation>Часи, місцеве g і його невизначеність, невизначеність головки. Те, що спільне для лабораторії, — у «Налаштуваннях» (Ctrl+,).</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The other tabs</source>
            <translation>Інші вкладки</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Gyros on the rate table, a check of the accuracy, live charts, noise, thermal tests, drift tables; Archive finds everything again by serial number. Ctrl and a digit open a tab.</source>
            <translation>Гіроскопи на поворотному стенді, перевірка точності, живі графіки, шум, температурні випробування, таблиці дрейфу; «Архів» знаходить усе за заводським номером. Ctrl і цифра відкривають вкладку.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Menu and help</source>
            <translation>Меню і довідка</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Light or dark, sounds, preferences, and this tour again. F1 shows all keys. That is all: press Space at any position, and the first calibration begins.</source>
            <translation>Світлий або темний вигляд, звуки, налаштування і цей огляд знову. F1 показує всі клавіші. Це все: натисніть Space у будь-якому положенні, і перше калібрування почнеться.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Well determined (14)</source>
            <translation>Добре визначені (14)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>U0, with K2·g²/2</source>
            <translation>U0, разом з K2·g²/2</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Sensitivity</source>
            <translation>Чутливість</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Misalignment, whole</source>
            <translation>Неспіввісність, загальна</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Split (18), if K2 = 0</source>
            <translation>Розклад (18), якщо K2 = 0</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>from</source>
            <translation>від</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>to (95 %)</source>
            <translation>до (95 %)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Fixture</source>
            <translation>Оснастка</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Sensor in its case</source>
            <translation>Датчик у корпусі</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>k across</source>
            <translation>k впоперек</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Fixture and sensor apart</source>
            <translation>Оснастка і датчик окремо</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Half sum and half difference of the two mounts; nothing is assumed of K2</source>
            <translation>Півсума і піврізниця двох встановлень; щодо K2 нічого не припускається</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>{pairs} angles twice</source>
            <translation>кутів двічі: {pairs}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Drift over a full turn</source>
            <translation>Дрейф за повний оберт</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Angles that came again, e.g. 5° and 365°</source>
            <translation>Кути, що повторилися, напр. 5° і 365°</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Test turns (4), (5), (8), (11)</source>
            <translation>Випробувальні оберти (4), (5), (8), (11)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/pictures.py" />
            <source>pass {number}</source>
            <translation>прохід {number}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>This run is no tumble that can be used</source>
            <translation>Ця серія не є придатним обертом</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>{file}: {readings} readings at {angles} angles, {mounts}</source>
            <translation>{file}: {readings} [показ|покази|показів] на {angles} кутах, {mounts}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>One accelerometer through a full turn of the dividing head.

Measure the plan fourier_400 (5° to 400° by 5°) or fourier_flip in the tab Dividing head, then press Measured Session (Space); or Load Data (Ctrl+O): a session, a run file, a text file of ClbAcc or Pointer.</source>
            <translation>Один акселерометр через повний оберт ділильної головки.

Виміряйте план fourier_400 (від 5° до 400° через 5°) або fourier_flip у вкладці «Ділильна головка», потім натисніть «Виміряний сеанс» (Space); або «Завантажити дані» (Ctrl+O): сеанс, файл серії, текстовий файл ClbAcc чи Pointer.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>Measured Session</source>
            <translation>Виміряний сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Stop</source>
            <translation>Зупинити</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Accumulate Data</source>
            <translation>Накопичити дані</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Repeat</source>
            <translation>Повторити</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Process Data</source>
            <translation>Обробити дані</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/table_picture.py" />
            <source>the table stands</source>
            <translation>стенд стоїть</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/table_picture.py" />
            <source>{axis} down</source>
            <translation>{axis} вниз</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/table_picture.py" />
            <source>{axis} up</source>
            <translation>{axis} вгору</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/checking.py" />
            <source>{name} holds the test {test}, no accuracy check</source>
            <translation>{name} містить випробування {test}, а не перевірку точності</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/checking.py" />
            <source>{name} is not used: {error}</source>
            <translation>{name} не використано: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/checking.py" />
            <source>the archive was not asked for the nearest calibration: {error}</source>
            <translation>архів не запитано про найближче калібрування: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/demo.py" />
            <source>Accuracy</source>
            <translation>Точність</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/demo.py" />
            <source>the rig did not answer</source>
            <translation>стенд не відповів</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/demo.py" />
            <source>the angles were not judged</source>
            <translation>кути не оцінено</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>accuracy calibration</source>
            <translation>калібрування для перевірки точності</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/results.py" />
            <source>the verdict was not kept: {error}</source>
            <translation>рішення не збережено: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>accuracy angles</source>
            <translation>accuracy angles</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Min</source>
            <translation>Мін.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Max</source>
            <translation>Макс.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Noise STD</source>
            <translation>СКВ шуму</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>a plan without a prediction has no table</source>
            <translation>план без передбачення не має таблиці</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/page.py" />
            <source>Prediction {plan_id}</source>
            <translation>Передбачення {plan_id}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Space</source>
            <translation>Space</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>dividing head</source>
            <translation>ділильна головка</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>rate table</source>
            <translation>поворотний стенд</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>climate chamber</source>
            <translation>термокамера</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>level base</source>
            <translation>горизонтальна основа</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>noise with memory</source>
            <translation>шум із пам'яттю</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>noise of a record at rest: likelihood of its spectrum and Allan deviation, terms of IEEE Std 952 and IEEE Std 1431, practicum (6.3), (6.4)</source>
            <translation>шум запису в спокої: правдоподібність спектра і девіація Аллана, терміни IEEE Std 952 та IEEE Std 1431, практикум (6.3), (6.4)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>angle random walk</source>
            <translation>випадкове блукання кута</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>bias instability</source>
            <translation>нестабільність зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>rate random walk</source>
            <translation>випадкове блукання швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>rate ramp</source>
            <translation>лінійний дрейф швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>angle quantization</source>
            <translation>квантування кута</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>velocity random walk</source>
            <translation>випадкове блукання швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>acceleration random walk</source>
            <translation>випадкове блукання прискорення</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>acceleration ramp</source>
            <translation>лінійний дрейф прискорення</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>velocity quantization</source>
            <translation>квантування швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>Noise coefficients, 95 %</source>
            <translation>Коефіцієнти шуму, 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>Allan deviation with its 95 % limits</source>
            <translation>Девіація Аллана з межами 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>averaging time τ, s</source>
            <translation>час усереднення τ, s</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>no term was fitted</source>
            <translation>жодного члена не визначено</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>{name}: its noise cannot be certified: {why}</source>
            <translation>{name}: шум не можна засвідчити: {why}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>term (IEEE 952, IEEE 1431)</source>
            <translation>термін (IEEE 952, IEEE 1431)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>stated as</source>
            <translation>подано як</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>from … to</source>
            <translation>від … до</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>fitted model</source>
            <translation>оцінена модель</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>length of the record</source>
            <translation>тривалість запису</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>sampling rate</source>
            <translation>частота вибірки</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>highest frequency fitted</source>
            <translation>найвища апроксимована частота</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>scale factor</source>
            <translation>масштабний коефіцієнт</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>cannot be read: {strerror}</source>
            <translation>неможливо прочитати: {strerror}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>Allan</source>
            <translation>Аллан</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>the plot did not come</source>
            <translation>графік не з'явився</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>a record was not analysed</source>
            <translation>запис не проаналізовано</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>there are no records to analyse</source>
            <translation>немає записів для аналізу</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>play the part live first</source>
            <translation>спершу програйте частину live</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>{name} was not written</source>
            <translation>{name} не записано</translation>
        </message>
        <message>
            <location filename="../../gui/allan/exporting.py" />
            <source>no analysed record is shown; analyse a record first</source>
            <translation>проаналізованого запису не показано; спершу проаналізуйте запис</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>σ²(τ) = R²τ²/2 + K²τ/3 + B²·(2/π) ln 2 + N²/τ + 3Q²/τ²   (6.4)</source>
            <translation>σ²(τ) = R²τ²/2 + K²τ/3 + B²·(2/π) ln 2 + N²/τ + 3Q²/τ²   (6.4)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Whittle</source>
            <translation>Віттл</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>least squares</source>
            <translation>найменші квадрати</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>{grouped} samples at {rate} Hz, {duration}, in {plain_unit}</source>
            <translation>{grouped} [відлік|відліки|відліків] при {rate} Hz, {duration}, у {plain_unit}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>{grouped} samples at {rate} Hz, {duration}</source>
            <translation>{grouped} [відлік|відліки|відліків] при {rate} Hz, {duration}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Whittle: likelihood of the spectrum, published. Least squares of σ²(τ): independent opinion. Graphical: the practicum's reading; it always finds a B.</source>
            <translation>Віттл: правдоподібність спектра, публікується. Найменші квадрати σ²(τ): незалежна думка. Графічно: спосіб практикуму; він завжди знаходить B.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Weighted with the noise that is left; powers of the channel less its mean ({means}).</source>
            <translation>З вагами за шумом, що залишився; степені каналу мінус його середнє ({means}).</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>cannot be used</source>
            <translation>неможливо використати</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>{device} {name}, live</source>
            <translation>{device} {name}, наживо</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Comparison of the devices (lab 6)</source>
            <translation>Порівняння пристроїв (лабораторна 6)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>By method</source>
            <translation>За методами</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Limits of one sigma; no terms are fitted to it.</source>
            <translation>Межі однієї сигми; складових за ними не оцінюють.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Before and after the regression</source>
            <translation>До і після регресії</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Regression</source>
            <translation>Регресія</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>What a longer record would give</source>
            <translation>Що дав би довший запис</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Relative standard uncertainties; the smallest B is found four times in five.</source>
            <translation>Відносні стандартні невизначеності; найменше B знаходять у чотирьох випадках із п'яти.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>there is no regression</source>
            <translation>регресії немає</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>smallest B, {plain_unit}</source>
            <translation>найменше B, {plain_unit}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>not found</source>
            <translation>не знайдено</translation>
        </message>
        <message>
            <location filename="../../gui/allan/live.py" />
            <source>waiting for samples</source>
            <translation>очікування відліків</translation>
        </message>
        <message>
            <location filename="../../gui/allan/live.py" />
            <source>the sample rate is being measured</source>
            <translation>вимірюється частота відліків</translation>
        </message>
        <message>
            <location filename="../../gui/allan/picture.py" />
            <source>{name}, before regression</source>
            <translation>{name}, до регресії</translation>
        </message>
        <message>
            <location filename="../../gui/allan/picture.py" />
            <source>{name}, after</source>
            <translation>{name}, після</translation>
        </message>
        <message>
            <location filename="../../gui/allan/plot_view.py" />
            <source>, slope {slopes}</source>
            <translation>, нахил {slopes}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>No device is connected: open Properties at the top.</source>
            <translation>Пристрій не під'єднано: відкрийте «Властивості» вгорі.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Add Records (Ctrl+O) reads records of a sensor at rest: recordings, files of CVGCom, run files, columns of numbers. An hour at 100 Hz is a good beginning.

Live curve (Space) draws the curve of the connected device while it runs.</source>
            <translation>«Додати записи» (Ctrl+O) читає записи датчика в спокої: записи програми, файли CVGCom, файли серій, стовпці чисел. Година при 100 Hz — добрий початок.

«Жива крива» (Space) малює криву під'єднаного пристрою під час його роботи.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>is being analysed …</source>
            <translation>аналізується…</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>The live curve begins in some seconds: {why}.</source>
            <translation>Жива крива почнеться за кілька секунд: {why}.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>The record is being read and analysed …</source>
            <translation>Запис читається й аналізується…</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>{grouped} samples</source>
            <translation>{grouped} [відлік|відліки|відліків]</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>growing: {detail}</source>
            <translation>зростає: {detail}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>{duration} at {rate} Hz, {unit}</source>
            <translation>{duration} at {rate} Hz, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Stop live curve</source>
            <translation>Зупинити живу криву</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Live curve</source>
            <translation>Жива крива</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Add Records</source>
            <translation>Додати записи</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Analyse Recording</source>
            <translation>Аналіз запису</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>No live curve was begun.</source>
            <translation>Живу криву не розпочато.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Delete</source>
            <translation>Delete</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>{name} cannot be analysed</source>
            <translation>{name} неможливо проаналізувати</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Set its channel and rate at the left, or remove it from the list.</source>
            <translation>Вкажіть його канал і частоту ліворуч або приберіть його зі списку.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>{rate} Hz</source>
            <translation>{rate} Hz</translation>
        </message>
        <message>
            <location filename="../../gui/allan/tab.py" />
            <source>Allan deviation</source>
            <translation>Девіація Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/allan/tab.py" />
            <source>{path}: there is no plot yet</source>
            <translation>{path}: графіка ще немає</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>Hadamard deviation</source>
            <translation>Девіація Адамара</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>Modified Allan deviation</source>
            <translation>Модифікована девіація Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>Total deviation</source>
            <translation>Повна девіація</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>random walk, two-sided S = N^2</source>
            <translation>випадкове блукання, двостороннє S = N^2</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>noise density, one-sided</source>
            <translation>густина шуму, одностороння</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>flicker coefficient B</source>
            <translation>коефіцієнт флікеру B</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>floor of the Allan curve, 0.664 B</source>
            <translation>дно кривої Аллана, 0,664 B</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>random walk, two-sided</source>
            <translation>випадкове блукання, двостороннє</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>flicker coefficient</source>
            <translation>коефіцієнт флікеру</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>floor of the curve, 0.664 B</source>
            <translation>дно кривої, 0,664 B</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>N  two-sided</source>
            <translation>N  двостороння</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>√2 N  one-sided</source>
            <translation>√2 N  одностороння</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>B  flicker</source>
            <translation>B  флікер</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>0.664 B  floor</source>
            <translation>0,664 B  дно</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Live</source>
            <translation>Наживо</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Thermal</source>
            <translation>Термо</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Methods</source>
            <translation>Методи</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Model vs data</source>
            <translation>Модель і дані</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Archive</source>
            <translation>Архів</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Teach a board</source>
            <translation>Навчити плату</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Certificates</source>
            <translation>Сертифікати</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>No device is connected</source>
            <translation>Пристрій не під'єднано</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Choose the port of the unit in Device Properties; or try the program on its simulated rig, which speaks the same protocols.</source>
            <translation>Виберіть порт виробу у «Властивостях пристроїв» або випробуйте програму на симульованому стенді, що говорить тими самими протоколами.</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Start with pointer, clbacc, or a whole sim:// address.</source>
            <translation>Почніть з pointer, clbacc або повної адреси sim://.</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Simulated PW09</source>
            <translation>Симульований PW09</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Simulated assembly</source>
            <translation>Симульована збірка</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>No such rig</source>
            <translation>Такого стенда немає</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>A device file is refused</source>
            <translation>Файл пристрою відхилено</translation>
        </message>
        <message>
            <location filename="../../gui/archive/demo.py" />
            <source>the archive did not list all</source>
            <translation>архів показав не все</translation>
        </message>
        <message>
            <location filename="../../gui/archive/demo.py" />
            <source>the archive did not answer</source>
            <translation>архів не відповів</translation>
        </message>
        <message>
            <location filename="../../gui/archive/library.py" />
            <source>the window was closed; what was taken in stays</source>
            <translation>вікно закрито; те, що взято, лишається</translation>
        </message>
        <message>
            <location filename="../../gui/archive/questions.py" />
            <source>is no session: it has no raw bytes</source>
            <translation>не сеанс: у нього немає необроблених байтів</translation>
        </message>
        <message>
            <location filename="../../gui/archive/raw.py" />
            <source>{path}: profile</source>
            <translation>{path}: профіль</translation>
        </message>
        <message>
            <location filename="../../gui/archive/raw.py" />
            <source>holds no device file by which its bytes could be read</source>
            <translation>не містить файла пристрою, за яким можна прочитати його байти</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>{marked} of {len} differ by more than 2 u</source>
            <translation>{marked} з {len} відрізняються більше ніж на 2 u</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>not counted</source>
            <translation>не враховано</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>drift, not significant</source>
            <translation>дрейф, незначущий</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>not possible</source>
            <translation>неможливо</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>the same</source>
            <translation>те саме</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>repeatability s</source>
            <translation>повторюваність s</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>s beyond the u</source>
            <translation>s понад u</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>The last bytes are not recorded</source>
            <translation>Останні байти не записано</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>No link</source>
            <translation>Немає зв'язку</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>raw log</source>
            <translation>необроблений журнал</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>Bytes are not recorded</source>
            <translation>Байти не записуються</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>The port stays busy</source>
            <translation>Порт лишається зайнятим</translation>
        </message>
        <message>
            <location filename="../../gui/devices/link.py" />
            <source>{folder}: cannot be made ({strerror})</source>
            <translation>{folder}: неможливо створити ({strerror})</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>The ports cannot be looked at</source>
            <translation>Порти неможливо переглянути</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Listening</source>
            <translation>Прослуховування</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Asking at</source>
            <translation>Запит на</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Listening at</source>
            <translation>Прослуховування на</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>A device file is wrong</source>
            <translation>Файл пристрою неправильний</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Choose a port first.</source>
            <translation>Спершу виберіть порт.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>{verb} {url}, {baud} baud</source>
            <translation>{verb} {url}, {baud} baud</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{url}: nothing came at any baud rate.</source>
            <translation>{url}: на жодній швидкості нічого не прийшло.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{url}: bytes came that no device file explains.</source>
            <translation>{url}: прийшли байти, яких не пояснює жоден файл пристрою.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>Ask for the names at {join}? The unit is stopped, asked and started again.</source>
            <translation>Запитати назви на {join}? Виріб буде зупинено, запитано і запущено знову.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>Ask at {join}? Identify commands of all known devices are sent; agree only if nothing else is connected there.</source>
            <translation>Запитати на {join}? Буде надіслано команди розпізнавання всіх відомих пристроїв; погоджуйтеся, лише якщо там не під'єднано нічого іншого.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>The ports are in use</source>
            <translation>Порти використовуються</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>Stop the accumulation first.</source>
            <translation>Спершу зупиніть накопичення.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{frames} frames</source>
            <translation>кадрів: {frames}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>it answered</source>
            <translation>відповів</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{url}: {name}, {baud} baud ({heard}).</source>
            <translation>{url}: {name}, {baud} baud ({heard}).</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>It could also be {name}.</source>
            <translation>Це може бути також {name}.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/state.py" />
            <source>The scan goes on</source>
            <translation>Пошук триває</translation>
        </message>
        <message>
            <location filename="../../gui/devices/state.py" />
            <source>Choose a port for every device</source>
            <translation>Виберіть порт для кожного пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/devices/state.py" />
            <source>Two devices have the same port</source>
            <translation>Два пристрої мають той самий порт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Port Name</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device file</source>
            <translation>Файл пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>found by Scan</source>
            <translation>знайдено пошуком</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Try again</source>
            <translation>Спробувати знову</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The program stood still for {float} s, as when the computer sleeps. What the port could not hold meanwhile is lost: a device with a counter tells how much, the record of another one runs on as if no time had passed.</source>
            <translation>Програма стояла {float} s, як коли комп'ютер спить. Те, чого порт за цей час не вмістив, втрачено: пристрій із лічильником каже скільки, а запис іншого триває, наче час не минав.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Nothing comes from {url}</source>
            <translation>Від {url} нічого не надходить</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The port is open, and no byte has arrived.</source>
            <translation>Порт відкрито, але не прийшло жодного байта.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Check the supply of the unit and the cable, or choose another port.</source>
            <translation>Перевірте живлення виробу і кабель або виберіть інший порт.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Link lost: {partition}</source>
            <translation>Зв'язок втрачено: {partition}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>{name}: {why}. Everything accepted so far is on the disk.</source>
            <translation>{name}: {why}. Усе прийняте досі вже на диску.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Plug the adapter in again; the program reconnects by itself and goes on.</source>
            <translation>Під'єднайте адаптер знову; програма сама відновить зв'язок і продовжить.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>{name} has stopped sending</source>
            <translation>{name} перестав передавати</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The port {url} is open, but no frame has come for {silent_s} s.</source>
            <translation>Порт {url} відкрито, але кадрів немає вже {silent_s} s.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Check the supply of the unit; measuring goes on by itself when frames come.</source>
            <translation>Перевірте живлення виробу; вимірювання продовжиться саме, коли прийдуть кадри.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Nothing that comes from {url} can be read</source>
            <translation>Те, що надходить від {url}, прочитати неможливо</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>{bytes} bytes have come, and no frame of the profile was among them.</source>
            <translation>Прийшло {bytes} [байт|байти|байтів], і серед них немає жодного кадру профілю.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The baud rate or the profile is wrong: scan the port.</source>
            <translation>Швидкість або профіль неправильні: запустіть пошук на порту.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>; tells apart</source>
            <translation>; розрізняє</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the session was not calibrated</source>
            <translation>сеанс не прокалібровано</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>nothing was found</source>
            <translation>нічого не знайдено</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the search did not end</source>
            <translation>пошук не завершився</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the effect was not added</source>
            <translation>ефект не додано</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the rig did not walk the rows</source>
            <translation>стенд не пройшов рядки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the calibration did not take the effect</source>
            <translation>калібрування не взяло ефекту</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>Mixed angles, twice</source>
            <translation>Кути упереміш, двічі</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>model vs data</source>
            <translation>модель і дані</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>discrepancy export</source>
            <translation>discrepancy export</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>discrepancy plan</source>
            <translation>план за розбіжністю</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>{folder}: a thousand plans are named {stem}; take some away</source>
            <translation>{folder}: тисяча планів має назву {stem}; приберіть частину</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/record_steps.py" />
            <source>a record is explained as a whole: {effect} was not found beside the other effects, and only what was found is added to it</source>
            <translation>запис пояснюється в цілому: {effect} поруч з іншими ефектами не знайдено, а додається до нього лише знайдене</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>sensor {name}</source>
            <translation>датчик {name}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial.py" />
            <source>case {seed}</source>
            <translation>випадок {seed}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>blind trial</source>
            <translation>сліпе випробування</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_record.py" />
            <source>Blind trial</source>
            <translation>Сліпе випробування</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_record.py" />
            <source>Rate</source>
            <translation>Частота</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/working.py" />
            <source>a record is compared by itself: open one file at a time</source>
            <translation>запис порівнюється сам по собі: відкривайте по одному файлу</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/formats.py" />
            <source>Run file of the positions</source>
            <translation>Файл серії з положеннями</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/guide.py" />
            <source>No accelerometers</source>
            <translation>Немає акселерометрів</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/guide.py" />
            <source>{name} sends none, so that it cannot be measured here. Choose another device.</source>
            <translation>{name} їх не передає, тож тут його не виміряти. Виберіть інший пристрій.</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>{name} holds a {sensor} in the test {test}; here are accelerometers on the dividing head</source>
            <translation>{name} містить {sensor} у випробуванні {test}; тут акселерометри на ділильній головці</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>the calibration was not kept: {error}</source>
            <translation>калібрування не збережено: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>{name} is an accuracy check: load or measure the calibration of the triad first, then load this file</source>
            <translation>{name} — перевірка точності: спершу завантажте або виміряйте калібрування тріади, потім завантажте цей файл</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>{device}, {len} positions</source>
            <translation>{device}, положень: {len}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings.py" />
            <source>None</source>
            <translation>Немає</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings.py" />
            <source>Auto</source>
            <translation>Авто</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings.py" />
            <source>Manual</source>
            <translation>Вручну</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>α, ang. min.</source>
            <translation>α, arcmin</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>β, ang. min.</source>
            <translation>β, arcmin</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>γ, deg.</source>
            <translation>γ, deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>ψ, deg.</source>
            <translation>ψ, deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Base orientation {name}</source>
            <translation>Базова орієнтація {name}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Tilter {name}</source>
            <translation>Нахилювач {name}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>{replace} ODH</source>
            <translation>{replace} ODH</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>{name}, deg</source>
            <translation>{name}, deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Parameters (Table {triad})</source>
            <translation>Параметри (таблиця {triad})</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Derived quantities</source>
            <translation>Похідні величини</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Measured outputs and residuals, {unit} (Table {is_triad})</source>
            <translation>Виміряні виходи і залишки, {unit} (таблиця {is_triad})</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Attitude check, deg</source>
            <translation>Перевірка орієнтації, deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Accuracy (Tables 2.5, 2.6): m/s² and deg</source>
            <translation>Точність (таблиці 2.5, 2.6): m/s² і deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Sensor</source>
            <translation>Датчик</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Mount</source>
            <translation>Встановлення</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Head</source>
            <translation>Головка</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Pitch set</source>
            <translation>Тангаж заданий</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Roll set</source>
            <translation>Крен заданий</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Row</source>
            <translation>Рядок</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>unit's own</source>
            <translation>власні виробу</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Misalignment towards {axis}</source>
            <translation>Неспіввісність до {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Triad</source>
            <translation>Тріада</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Non-orthogonality {pair}</source>
            <translation>Неортогональність {pair}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Mounting about {axis}</source>
            <translation>Установлення навколо {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>dividing_head thermal</source>
            <translation>dividing_head thermal</translation>
        </message>
        <message>
            <location filename="../../gui/drift/demo.py" />
            <source>no table was made</source>
            <translation>таблицю не створено</translation>
        </message>
        <message>
            <location filename="../../gui/drift/exporting.py" />
            <source>drift after switching on, source 003</source>
            <translation>дрейф після увімкнення, джерело 003</translation>
        </message>
        <message>
            <location filename="../../gui/drift/library.py" />
            <source>turn-ons in {join}; one unit is needed</source>
            <translation>увімкнення в {join}; потрібна одна одиниця</translation>
        </message>
        <message>
            <location filename="../../gui/drift/library.py" />
            <source>cannot be read: {error}</source>
            <translation>неможливо прочитати: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/library.py" />
            <source>{memory} bytes hold no table of {temperatures} temperatures; two knots need {temperatures2}</source>
            <translation>{memory} [байт|байти|байтів] не вміщають таблиці для {temperatures} [температури|температур|температур]; два вузли потребують {temperatures2}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/reading.py" />
            <source>{path}: holds a test {test}, no record since switching on</source>
            <translation>{path}: містить випробування {test}, а не запис від увімкнення</translation>
        </message>
        <message>
            <location filename="../../gui/drift/reading.py" />
            <source>{path}: no output {channel}; there are: {join}</source>
            <translation>{path}: немає виходу {channel}; є: {join}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/tab.py" />
            <source>Drift after switching on</source>
            <translation>Дрейф після увімкнення</translation>
        </message>
        <message>
            <location filename="../../gui/exporting.py" />
            <source>Not exported</source>
            <translation>Не експортовано</translation>
        </message>
        <message>
            <location filename="../../gui/exporting.py" />
            <source>Exported</source>
            <translation>Експортовано</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Saved: {saved}</source>
            <translation>Збережено: {saved}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>the layout was not found</source>
            <translation>будову не знайдено</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>Invented board</source>
            <translation>Вигадана плата</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>the device file could not be saved</source>
            <translation>файл пристрою не вдалося зберегти</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>invented board</source>
            <translation>вигадана плата</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>{hint}, no channel</source>
            <translation>{hint}, не канал</translation>
        </message>
        <message>
            <location filename="../../gui/frames/listening.py" />
            <source>unknown board</source>
            <translation>невідома плата</translation>
        </message>
        <message>
            <location filename="../../gui/frames/listening.py" />
            <source>holds no bytes of a device</source>
            <translation>не містить байтів пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>device file {path}</source>
            <translation>файл пристрою {path}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>End what is being measured there, then press Save and connect again.</source>
            <translation>Завершіть вимірювання, що там триває, потім натисніть «Зберегти і під'єднати» знову.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>The bytes cannot be had</source>
            <translation>Байтів неможливо отримати</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Looking for frames, checksum and numbers</source>
            <translation>Пошук кадрів, контрольної суми і чисел</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Looking for the checksum</source>
            <translation>Пошук контрольної суми</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>taught from {heard}</source>
            <translation>навчено з {heard}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Not connected yet</source>
            <translation>Ще не під'єднано</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>{name} is connected</source>
            <translation>{name} під'єднано</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Its numbers are drawn in the tab Live; every tab knows it by its roles.</source>
            <translation>Його числа малюються у вкладці «Наживо»; кожна вкладка знає його за ролями.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>A header has 1 to 8 bytes, and a frame more than it</source>
            <translation>Заголовок має від 1 до 8 байтів, а кадр — більше за нього</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>The device file is not saved</source>
            <translation>Файл пристрою не збережено</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>"{sync}" is no row of bytes like "AA 55"</source>
            <translation>«{sync}» не є рядком байтів на кшталт "AA 55"</translation>
        </message>
        <message>
            <location filename="../../gui/frames/saving.py" />
            <source>There is a device file "{stem}" of the program: choose another name</source>
            <translation>Є файл пристрою «{stem}» із програми: виберіть іншу назву</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Listening at every speed</source>
            <translation>Прослуховування на кожній швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Reading {name}</source>
            <translation>Читання {name}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>End what is being measured there, or choose another port.</source>
            <translation>Завершіть вимірювання, що там триває, або виберіть інший порт.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>No bytes from this port</source>
            <translation>З цього порту немає байтів</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Choose a port first</source>
            <translation>Спершу виберіть порт</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Listening at {baud} baud</source>
            <translation>Прослуховування на {baud} baud</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>The port is in use</source>
            <translation>Порт використовується</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Bytes come, but at no speed do they repeat themselves: choose the BaudRate of the board's manual and Listen, then type Header and Length</source>
            <translation>Байти надходять, але на жодній швидкості не повторюються: виберіть швидкість з інструкції плати, натисніть «Слухати», потім введіть заголовок і довжину</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Silent at every speed; is the board switched on?</source>
            <translation>Тиша на кожній швидкості; чи ввімкнено плату?</translation>
        </message>
        <message>
            <location filename="../../gui/frames/state.py" />
            <source>Nothing is described yet</source>
            <translation>Ще нічого не описано</translation>
        </message>
        <message>
            <location filename="../../gui/frames/taught.py" />
            <source>Give the board a name</source>
            <translation>Дайте платі назву</translation>
        </message>
        <message>
            <location filename="../../gui/frames/taught.py" />
            <source>the description</source>
            <translation>опис</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>no checksum</source>
            <translation>без контрольної суми</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{grouped} bytes</source>
            <translation>{grouped} [байт|байти|байтів]</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{text}, bytes {start} to {last}: {share} fit</source>
            <translation>{text}, байти від {start} до {last}: підходить {share}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>Byte {at} = {value}, {what}: frames of {length} bytes, {share} fit</source>
            <translation>Байт {at} = {value}, {what}: кадри по {length} байтів, підходить {share}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>none of the known checksums fits, so where a frame begins is a guess: the longest run of bytes that stay the same.</source>
            <translation>жодна з відомих контрольних сум не підходить, тож початок кадру — здогад: найдовший ряд незмінних байтів.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>no byte yet</source>
            <translation>ще жодного байта</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{text}, {grouped} a second</source>
            <translation>{text}, {grouped} за секунду</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>counts by {step}</source>
            <translation>рахує по {step}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>never changes</source>
            <translation>ніколи не змінюється</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>a noisy signal</source>
            <translation>шумний сигнал</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>rises or falls steadily</source>
            <translation>рівномірно зростає або спадає</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>a few values, seldom changing</source>
            <translation>кілька значень, рідко змінюється</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>the whole length</source>
            <translation>повна довжина</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>the payload, {add} bytes less</source>
            <translation>корисні дані, на {add} [байт|байти|байтів] менше</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>, {hz} a second</source>
            <translation>, {hz} за секунду</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>Lines of {len} numbers{rate}; {share} of them read.</source>
            <translation>Рядки по {len} чисел{rate}; прочитано {share}.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{text} fits {share} of them.</source>
            <translation>{text} підходить для {share} з них.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>How many come in a second is not told: {why}.</source>
            <translation>Скільки їх приходить за секунду, не відомо: {why}.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>Neither frames nor lines were found. Is the baud rate right? Noise at every speed means another parity, or a signal that is no serial one.</source>
            <translation>Не знайдено ні кадрів, ні рядків. Чи правильна швидкість? Шум на кожній швидкості означає іншу парність або сигнал, що не є послідовним.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/view.py" />
            <source>Drag over columns to point at bytes, Enter makes numbers of them, Delete takes them away. A double click points at a whole part.</source>
            <translation>Протягніть по стовпцях, щоб позначити байти; Enter робить з них числа, Delete прибирає. Подвійне клацання позначає всю частину.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/page.py" />
            <source>Gyrocompass {device}</source>
            <translation>Гірокомпас {device}</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/working.py" />
            <source>{name}: the rows tell no heading of the base (column head_deg)</source>
            <translation>{name}: рядки не містять курсу основи (стовпець head_deg)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/working.py" />
            <source>how long to average depends on the latitude: state it</source>
            <translation>тривалість усереднення залежить від широти: вкажіть її</translation>
        </message>
        <message>
            <location filename="../../gui/hooks.py" />
            <source>A fault inside the program</source>
            <translation>Помилка всередині програми</translation>
        </message>
        <message>
            <location filename="../../gui/hooks.py" />
            <source>{name}: {fault}. What was accepted is on the disk.</source>
            <translation>{name}: {fault}. Прийняте вже на диску.</translation>
        </message>
        <message>
            <location filename="../../gui/hooks.py" />
            <source>Go on; if something behaves oddly, start the program anew and resume.</source>
            <translation>Продовжуйте; якщо щось працює дивно, запустіть програму знову і продовжте сеанс.</translation>
        </message>
        <message>
            <location filename="../../gui/jobs.py" />
            <source>calrig {name}</source>
            <translation>calrig {name}</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Plot</source>
            <translation>Графік</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Dial</source>
            <translation>Шкала</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Callout</source>
            <translation>Підказка</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Banner</source>
            <translation>Повідомлення</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Return</source>
            <translation>Return</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Up Down</source>
            <translation>Up Down</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Left Right</source>
            <translation>Left Right</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Home</source>
            <translation>Home</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>End</source>
            <translation>End</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Ctrl+Left Ctrl+Right</source>
            <translation>Ctrl+Left Ctrl+Right</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>PgUp PgDown</source>
            <translation>PgUp PgDown</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Shift+Left Shift+Right</source>
            <translation>Shift+Left Shift+Right</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Del</source>
            <translation>Del</translation>
        </message>
        <message>
            <location filename="../../gui/keys/showing.py" />
            <source>The sheet of keys is ready to be printed</source>
            <translation>Аркуш клавіш готовий до друку</translation>
        </message>
        <message>
            <location filename="../../gui/keys/showing.py" />
            <source>The sheet of keys is not written</source>
            <translation>Аркуш клавіш не записано</translation>
        </message>
        <message>
            <location filename="../../gui/keys/showing.py" />
            <source>Make room there, or choose another folder of sessions in Preferences.</source>
            <translation>Звільніть там місце або виберіть іншу теку сеансів у «Налаштуваннях».</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>the record was not averaged</source>
            <translation>запис не усереднено</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>no samples came</source>
            <translation>відліки не прийшли</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>nothing was recorded</source>
            <translation>нічого не записано</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>door opened</source>
            <translation>двері відчинено</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>the hour was not recorded</source>
            <translation>годину не записано</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>{device} GyroOut</source>
            <translation>{device} GyroOut</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>export failed</source>
            <translation>експорт не вдався</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>Charts, SVG</source>
            <translation>Графіки, SVG</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>Charts, PNG</source>
            <translation>Графіки, PNG</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>Charts, PDF</source>
            <translation>Графіки, PDF</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>{name} and {table} written</source>
            <translation>{name} і {table} записано</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Max − Min</source>
            <translation>Макс. − мін.</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Slope, 1/s</source>
            <translation>Нахил, 1/s</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>interrupted record</source>
            <translation>перерваний запис</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>interrupted records</source>
            <translation>перервані записи</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>So were {n} others.</source>
            <translation>Так само ще {n}.</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>The record stays where it was</source>
            <translation>Запис лишається там, де був</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>Samples are not recorded</source>
            <translation>Відліки не записуються</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>CVGCom's file ends here</source>
            <translation>Файл CVGCom тут закінчується</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>The end of the record is not stored</source>
            <translation>Кінець запису не збережено</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>cannot take the record: {strerror}</source>
            <translation>неможливо прийняти запис: {strerror}</translation>
        </message>
        <message>
            <location filename="../../gui/live/loading.py" />
            <source>{name} has been opened with doubts</source>
            <translation>{name} відкрито із застереженнями</translation>
        </message>
        <message>
            <location filename="../../gui/live/loading.py" />
            <source>The record cannot be opened</source>
            <translation>Запис неможливо відкрити</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>exists already; nothing measured is overwritten</source>
            <translation>вже існує; нічого виміряного не перезаписується</translation>
        </message>
        <message>
            <location filename="../../gui/live/presenter.py" />
            <source>{port}, {name}, {rate_hz} Hz</source>
            <translation>{port}, {name}, {rate_hz} Hz</translation>
        </message>
        <message>
            <location filename="../../gui/live/presenter.py" />
            <source>The record cannot begin</source>
            <translation>Запис неможливо почати</translation>
        </message>
        <message>
            <location filename="../../gui/live/sample_files.py" />
            <source>CSV (1.5, …)</source>
            <translation>CSV (1.5, …)</translation>
        </message>
        <message>
            <location filename="../../gui/live/sample_files.py" />
            <source>CSV (1,5; …)</source>
            <translation>CSV (1,5; …)</translation>
        </message>
        <message>
            <location filename="../../gui/live/sample_files.py" />
            <source>MATLAB 5 holds 2 GB at most: choose a shorter stretch, or CSV</source>
            <translation>MATLAB 5 вміщує щонайбільше 2 GB: виберіть коротшу ділянку або CSV</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{count} GB</source>
            <translation>{count} GB</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{count} MB</source>
            <translation>{count} MB</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{folder}: the disk has {megabytes} left, which last {lasting} at {per_s} kB/s; free some space first</source>
            <translation>{folder}: на диску лишилося {megabytes}, вистачить на {lasting} при {per_s} kB/s; спершу звільніть місце</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{there}: cannot be looked at: {strerror}</source>
            <translation>{there}: неможливо переглянути: {strerror}</translation>
        </message>
        <message>
            <location filename="../../gui/live/tab.py" />
            <source>A record is running.</source>
            <translation>Триває запис.</translation>
        </message>
        <message>
            <location filename="../../gui/live/trace.py" />
            <source>link lost</source>
            <translation>зв'язок втрачено</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>{rate_hz} Hz</source>
            <translation>{rate_hz} Hz</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>CEP / CWV {cep} / {cwv}</source>
            <translation>CEP / CWV {cep} / {cwv}</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>there is no command {arguments}; there are: {join}</source>
            <translation>команди {arguments} немає; є: {join}</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>calrig [--simulated [DEVICE]] [--folder FOLDER] | calrig COMMAND ...</source>
            <translation>calrig [--simulated [DEVICE]] [--folder FOLDER] | calrig COMMAND ...</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>Calibration bench for gyroscopes and accelerometers.
Without a command the window opens.</source>
            <translation>Calibration bench for gyroscopes and accelerometers.
Without a command the window opens.</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>commands (`calrig COMMAND --help` tells more):
{listing}</source>
            <translation>commands (`calrig COMMAND --help` tells more):
{listing}</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>open the window on the simulated rig: pointer, clbacc, or a whole sim:// address</source>
            <translation>відкрити вікно на симульованому стенді: pointer, clbacc або повна адреса sim://</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>folder of all sessions (~/CalRig)</source>
            <translation>тека всіх сеансів (~/CalRig)</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>calrig {version}</source>
            <translation>calrig {version}</translation>
        </message>
        <message>
            <location filename="../../gui/measured_file.py" />
            <source>holds nothing that a certificate can be made of</source>
            <translation>не містить нічого, з чого можна скласти сертифікат</translation>
        </message>
        <message>
            <location filename="../../gui/measured_file.py" />
            <source>holds the test {test}; certificates are made of {join}, record</source>
            <translation>містить випробування {test}; сертифікати складають із {join}, record</translation>
        </message>
        <message>
            <location filename="../../gui/measured_file.py" />
            <source>holds several devices: {names}; choose one of them</source>
            <translation>містить кілька пристроїв: {names}; виберіть один</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>Effects that were added to the model</source>
            <translation>Ефекти, додані до моделі</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>Effect</source>
            <translation>Ефект</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>Where</source>
            <translation>Де</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>taken out in use</source>
            <translation>вилучається під час роботи</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>this test alone</source>
            <translation>лише це випробування</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>No device</source>
            <translation>Немає пристрою</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>Open Properties at the top, choose the port, press Scan and OK.</source>
            <translation>Відкрийте «Властивості» вгорі, виберіть порт, натисніть «Пошук» і OK.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>Waiting for samples</source>
            <translation>Очікування відліків</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>The port is open. The first frame has not come yet.</source>
            <translation>Порт відкрито. Перший кадр ще не прийшов.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>The sample rate is being measured.</source>
            <translation>Вимірюється частота відліків.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>accept as</source>
            <translation>прийняти як</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Take it anyway</source>
            <translation>Узяти попри це</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{capitalize} {number}, {done_before} of {total}.</source>
            <translation>{capitalize} {number}, {done_before} з {total}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{capitalize} {number} done</source>
            <translation>{capitalize} {number} готово</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>On the disk. Next: {noun} {number}, {place}, {setting}.</source>
            <translation>На диску. Далі: {noun} {number}, {place}, {setting}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Nothing is being measured.</source>
            <translation>Нічого не вимірюється.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{order}, {place}; or measure what is there.</source>
            <translation>{order}, {place}; або виміряйте те, що стоїть.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>All {nouns} at {here} are done</source>
            <translation>Усі {nouns} при {here} виміряно</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Set the chamber to {after}, wait until the unit has its temperature, then go on.</source>
            <translation>Встановіть камеру на {after}, зачекайте, доки виріб набуде температури, потім продовжуйте.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Link lost</source>
            <translation>Зв'язок втрачено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Everything accepted so far is on the disk. Measuring goes on when the device is back.</source>
            <translation>Усе прийняте досі вже на диску. Вимірювання продовжиться, коли пристрій повернеться.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Not taken</source>
            <translation>Не прийнято</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{done_before} {nouns} are on the disk.</source>
            <translation>{nouns} на диску: {done_before}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>It settles; then press Space to accumulate {time}.</source>
            <translation>Заспокоюється; потім натисніть Space, щоб накопичувати {time}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{asked}Then press Space to accumulate {time}.</source>
            <translation>{asked}Потім натисніть Space, щоб накопичувати {time}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Settling</source>
            <translation>Чекаю спокою</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Nothing was recorded; see below.</source>
            <translation>Нічого не записано; див. нижче.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Press Process Data (F5).</source>
            <translation>Натисніть «Обробити дані» (F5).</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Too short</source>
            <translation>Закоротко</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Accept as {noun} {number}</source>
            <translation>Прийняти як {noun} {number}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Measure {noun} {number}</source>
            <translation>Виміряти {noun} {number}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Nothing has been recorded under {label}.</source>
            <translation>Під {label} нічого не записано.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>the plan was not finished</source>
            <translation>план не завершено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>nothing was processed</source>
            <translation>нічого не оброблено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>no position was accepted</source>
            <translation>жодного положення не прийнято</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>no accumulation began</source>
            <translation>накопичення не почалося</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/formats.py" />
            <source>legacy {id}</source>
            <translation>legacy {id}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/head_words.py" />
            <source>Turn to {angle_words}</source>
            <translation>Задайте {angle_words}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/head_words.py" />
            <source>{words}, re-indexed by {reindex}°</source>
            <translation>{words}, переставлено на {reindex}°</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/keeper.py" />
            <source>no session is open</source>
            <translation>жодного сеансу не відкрито</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>give the mounts</source>
            <translation>вкажіть встановлення</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>{name} holds {len} devices</source>
            <translation>{name} містить {len} [пристрій|пристрої|пристроїв]</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>Which one shall be processed?</source>
            <translation>Який обробити?</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>mounts {mounts}</source>
            <translation>встановлення {mounts}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>It stood {replace}</source>
            <translation>Він стояв {replace}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>device {name}</source>
            <translation>пристрій {name}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/presenter.py" />
            <source>Free angles</source>
            <translation>Довільні кути</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/printed.py" />
            <source>info, warning or error</source>
            <translation>info, warning або error</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/printed.py" />
            <source>pairs of value and uncertainty</source>
            <translation>пари значення і невизначеності</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results.py" />
            <source>{key} results</source>
            <translation>{key} results</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results.py" />
            <source>The data cannot be processed</source>
            <translation>Дані неможливо обробити</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>Continue it</source>
            <translation>Продовжити його</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>{key} unfinished</source>
            <translation>{key} unfinished</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>{others} older ones wait in the folder of sessions.</source>
            <translation>У теці сеансів чекають старіші: {others}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>A session of {device} is not finished</source>
            <translation>Сеанс {device} не завершено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>Begun {started}, {done} of {total} {nouns} are on the disk.{more}</source>
            <translation>Почато {started}, на диску {done} з {total}, {nouns}.{more}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>a session that cannot be read is not offered</source>
            <translation>сеанс, який неможливо прочитати, не пропонується</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>It belongs to the session; press New session to change it</source>
            <translation>Належить сеансу; щоб змінити, натисніть «Новий сеанс»</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>An accumulation is running</source>
            <translation>Триває накопичення</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>All is done; pick a line of the list to measure it once more</source>
            <translation>Усе виміряно; виберіть рядок списку, щоб виміряти його ще раз</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>The link is lost</source>
            <translation>Зв'язок втрачено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>{key} storage</source>
            <translation>{key} storage</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>{key} other device</source>
            <translation>{key} other device</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>Not stored</source>
            <translation>Не збережено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>{name} cannot go on with the session of {device}</source>
            <translation>{name} не може продовжити сеанс {device}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>It sends other channels.</source>
            <translation>Він передає інші канали.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>Connect the unit that the session was begun with, or press New session.</source>
            <translation>Під'єднайте виріб, з яким почато сеанс, або натисніть «Новий сеанс».</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>No session can be made</source>
            <translation>Сеанс неможливо створити</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>The text file is behind</source>
            <translation>Текстовий файл відстав</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>{key} export</source>
            <translation>{key} export</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>An accumulation is running.</source>
            <translation>Триває накопичення.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>{key} session</source>
            <translation>{key} session</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>The session cannot be opened</source>
            <translation>Сеанс неможливо відкрити</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>Store again</source>
            <translation>Зберегти знову</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{key} position</source>
            <translation>{key} position</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{key} not stored</source>
            <translation>{key} not stored</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{label} discarded</source>
            <translation>{label} відкинуто</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>It is held in memory until it is stored or measured again.</source>
            <translation>Його збережено в пам'яті, доки не буде записано або виміряно знову.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>Make room on the disk, then store it again.</source>
            <translation>Звільніть місце на диску, потім збережіть знову.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{label} taken back</source>
            <translation>{label} скасовано</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>accumulated for {label}, recorded as {label2}</source>
            <translation>накопичено для {label}, записано як {label2}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{label} is measured, but not on the disk</source>
            <translation>{label} виміряно, але не на диску</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>taken by the operator</source>
            <translation>прийнято оператором</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Accumulates by itself once the unit is at rest.</source>
            <translation>Накопичує сам, коли виріб у спокої.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>The unit is moving.</source>
            <translation>Виріб рухається.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>At rest; hands off.</source>
            <translation>У спокої; не торкайтеся.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Do not touch the head.</source>
            <translation>Не торкайтеся головки.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>The head moved</source>
            <translation>Головка рухалася</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Wrong position</source>
            <translation>Неправильне положення</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Positions</source>
            <translation>Положення</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>All {nouns} done</source>
            <translation>Виміряно всі {nouns}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Bolt the unit on anew with {place}.</source>
            <translation>Закріпіть виріб знову, {place}.</translation>
        </message>
        <message>
            <location filename="../../gui/messages.py" />
            <source>Nothing was changed. Choose another file, or correct the place that is named.</source>
            <translation>Нічого не змінено. Виберіть інший файл або виправте назване місце.</translation>
        </message>
        <message>
            <location filename="../../gui/messages.py" />
            <source>Make room there, or choose another folder; then try again.</source>
            <translation>Звільніть там місце або виберіть іншу теку; потім спробуйте знову.</translation>
        </message>
        <message>
            <location filename="../../gui/methods/comparison_demo.py" />
            <source>the files were not read</source>
            <translation>файли не прочитано</translation>
        </message>
        <message>
            <location filename="../../gui/methods/comparison_demo.py" />
            <source>there is no noise to compare</source>
            <translation>немає шуму для порівняння</translation>
        </message>
        <message>
            <location filename="../../gui/methods/comparison_demo.py" />
            <source>play Allan first</source>
            <translation>спершу програйте частину Allan</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>the tumble was not evaluated</source>
            <translation>оберт не оцінено</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>no advice was given</source>
            <translation>поради не надано</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>nothing was proposed</source>
            <translation>нічого не запропоновано</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>it was not chosen</source>
            <translation>його не вибрано</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>the plan was not predicted</source>
            <translation>план не передбачено</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/demo.py" />
            <source>legacy rotation_table</source>
            <translation>legacy rotation_table</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/formats.py" />
            <source>Run file of the rates</source>
            <translation>Файл серії зі швидкостями</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/free.py" />
            <source>Z down</source>
            <translation>Z вниз</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/free.py" />
            <source>Rotation Around {axis}, own list{name}</source>
            <translation>Обертання навколо {axis}, власний список{name}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/guide.py" />
            <source>the table changed its rate during the accumulation ({which}): it stopped, slowed down or was still gaining speed; wait until it turns steadily and accumulate again</source>
            <translation>стенд змінив швидкість під час накопичення ({which}): він зупинився, сповільнився або ще набирав швидкість; зачекайте, доки обертання стане рівномірним, і накопичте знову</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/guide.py" />
            <source>No gyros</source>
            <translation>Немає гіроскопів</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/guide.py" />
            <source>{name} stood at {mean} throughout: the gyro or its converter is at the end of its range, or the channel is stuck; leave the rate out, or measure a smaller one</source>
            <translation>{name} весь час показував {mean}: гіроскоп або його перетворювач на межі діапазону, або канал завис; пропустіть цю швидкість або виміряйте меншу</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>table and head run are not fitted together while effects are added: they were found in one of them alone</source>
            <translation>вимірювання на столі та на головці не оцінюються разом, доки додано ефекти: їх знайдено лише в одному з них</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>{names}: the scale factors are negative, which is legal; the outputs fall when the unit turns counter-clockwise seen from above</source>
            <translation>{names}: масштабні коефіцієнти від'ємні, що припустимо; виходи спадають, коли виріб обертається проти годинникової стрілки, якщо дивитися зверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>{name} holds a {sensor} in the test {test}; here are gyros on the rate table, or at rest on the dividing head</source>
            <translation>{name} містить {sensor} у випробуванні {test}; тут гіроскопи на поворотному стенді або в спокої на ділильній головці</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>there is nothing to process</source>
            <translation>обробляти нічого</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>same unit</source>
            <translation>той самий виріб</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>They are one unit</source>
            <translation>Це один виріб</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>Leave the other one out</source>
            <translation>Не брати другий</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>{key} two files</source>
            <translation>{key} two files</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>Table and head run are of two units</source>
            <translation>Серії стенда і головки — від двох виробів</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>{refused} Each was processed by itself.</source>
            <translation>{refused} Кожну оброблено окремо.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>holds, p = {worst}</source>
            <translation>прийнято, p = {worst}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Rate table: scale factor and zero (Table 3.6), U at 95 %</source>
            <translation>Поворотний стенд: масштабний коефіцієнт і нульовий сигнал (таблиця 3.6), U при 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>not tested</source>
            <translation>не перевірено</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>rejected, p = {worst}</source>
            <translation>відхилено, p = {worst}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Nonlinearity of {full_scale} deg/s</source>
            <translation>Нелінійність від {full_scale} deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Straightness, asymmetry, hysteresis, cross axes, U at 95 %</source>
            <translation>Прямолінійність, асиметрія, гістерезис, перехресні осі, U при 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Parameters</source>
            <translation>Параметри</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Error of the calibrated rate</source>
            <translation>Похибка каліброваної швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Set rate, deg/s</source>
            <translation>Задана швидкість, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Error, deg/s</source>
            <translation>Похибка, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Measured outputs, {unit}, and errors, deg/s (Table 3.4)</source>
            <translation>Виміряні виходи, {unit}, і похибки, deg/s (таблиця 3.4)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>g-sensitivity on the head (Table 3.6)</source>
            <translation>g-чутливість на головці (таблиця 3.6)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Measured outputs and residuals, {unit} (Table 3.5)</source>
            <translation>Виміряні виходи і залишки, {unit} (таблиця 3.5)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Rate table and head together (3.3)</source>
            <translation>Поворотний стенд і головка разом (3.3)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Calibrated rates, deg/s (Table 3.7)</source>
            <translation>Калібровані швидкості, deg/s (таблиця 3.7)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Errors of Table 3.7</source>
            <translation>Похибки таблиці 3.7</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Straight line</source>
            <translation>Пряма</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>k, {unit}/(deg/s)</source>
            <translation>k, {unit}/(deg/s)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Zero, {unit}</source>
            <translation>Нуль, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>ω set</source>
            <translation>ω задана</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>ω calibrated</source>
            <translation>ω калібрована</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Parabola</source>
            <translation>Парабола</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Cubic</source>
            <translation>Куб</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Zero without gravity</source>
            <translation>Нуль без сили тяжіння</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>k of positive rates</source>
            <translation>k додатних швидкостей</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>k of negative rates</source>
            <translation>k від'ємних швидкостей</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Asymmetry (IEEE 528)</source>
            <translation>Асиметрія (IEEE 528)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Bias asymmetry</source>
            <translation>Асиметрія зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Hysteresis, up less down</source>
            <translation>Гістерезис, вгору мінус вниз</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Threshold, between</source>
            <translation>Поріг, між</translation>
        </message>
        <message>
            <location filename="../../gui/record_noise.py" />
            <source>{name}: the record is in {unit}, no unit of a {kind}; state the scale factor, or type N, B and K as the Allan tab tells them</source>
            <translation>{name}: запис у {unit}, що не є одиницею {kind}; вкажіть масштабний коефіцієнт або введіть N, B і K, як їх показує вкладка Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>{replace} ODH, {words}</source>
            <translation>{replace} ODH, {words}</translation>
        </message>
        <message>
            <location filename="../../gui/services.py" />
            <source>no certificate can be made of files here</source>
            <translation>з файлів тут сертифіката не скласти</translation>
        </message>
        <message>
            <location filename="../../gui/settings.py" />
            <source>{path}: the preferences cannot be read ({error}); defaults are used</source>
            <translation>{path}: налаштування неможливо прочитати ({error}); узято типові</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/demo.py" />
            <source>the cycle was not processed</source>
            <translation>цикл не оброблено</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/exporting.py" />
            <source>outputs of a standing unit over temperature</source>
            <translation>виходи нерухомого виробу за температурою</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/exporting.py" />
            <source>nothing was found over temperature; see the notes</source>
            <translation>за температурою нічого не знайдено; див. примітки</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/tab.py" />
            <source>Over temperature</source>
            <translation>За температурою</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/working.py" />
            <source>a record of a standing unit is taken by itself: remove the others from the list</source>
            <translation>запис нерухомого виробу береться сам по собі: приберіть інші зі списку</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>New to CalRig?</source>
            <translation>Уперше в CalRig?</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>A tour on the simulated rig shows the window in two minutes; it also waits in Menu, Help.</source>
            <translation>Огляд на симульованому стенді за дві хвилини показує вікно; він є також у «Меню», «Довідка».</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>Start the tour</source>
            <translation>Почати огляд</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>Not now</source>
            <translation>Не зараз</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>+ C5 sin 3α + C6 cos 3α</source>
            <translation>+ C5 sin 3α + C6 cos 3α</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>tan 2α0 = C4/C3,  k_xy = sign(C3)·2/g²·√(C3² + C4²)</source>
            <translation>tan 2α0 = C4/C3,  k_xy = sign(C3)·2/g²·√(C3² + C4²)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>a study without a split has no table of it</source>
            <translation>дослідження без розкладу не має його таблиці</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>a study without a flip has no table of it</source>
            <translation>дослідження без перевертання не має його таблиці</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>sin {order}α</source>
            <translation>sin {order}α</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>cos {order}α</source>
            <translation>cos {order}α</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/page.py" />
            <source>Tumble {device}</source>
            <translation>Оберт {device}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>holds no session of the dividing head yet; measure one in that tab, or load a file</source>
            <translation>ще не містить сеансу ділильної головки; виміряйте його в тій вкладці або завантажте файл</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/chart_export.py" />
            <source>Title</source>
            <translation>Заголовок</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/chart_export.py" />
            <source>{path}: no such picture format; use {join}</source>
            <translation>{path}: немає такого формату рисунка; беріть {join}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/history.py" />
            <source>a history needs a positive rate, not {rate}</source>
            <translation>історія потребує додатної частоти, а не {rate}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/history.py" />
            <source>sample numbers from {index} do not follow {next}</source>
            <translation>номери відліків від {index} не йдуть за {next}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/number_text.py" />
            <source>an uncertainty of {uncertainty} gives no number of digits</source>
            <translation>невизначеність {uncertainty} не дає кількості цифр</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/screenshots.py" />
            <source>{path}: the picture could not be written</source>
            <translation>{path}: рисунок неможливо записати</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>to come</source>
            <translation>ще буде</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Backspace</source>
            <translation>Backspace</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/theme.py" />
            <source>DejaVu Sans</source>
            <translation>DejaVu Sans</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/theme.py" />
            <source>Fusion</source>
            <translation>Fusion</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>{own} (Language)</source>
            <translation>{own} (Language)</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Language</source>
            <translation>Мова</translation>
        </message>
        <message>
            <location filename="../../core/allan/conventions.py" />
            <source>angle quantisation</source>
            <translation>квантування кута</translation>
        </message>
        <message>
            <location filename="../../core/allan/conventions.py" />
            <source>velocity quantisation</source>
            <translation>квантування швидкості</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>a regression needs one stretch without gaps: choose 'longest'</source>
            <translation>регресія потребує однієї ділянки без пропусків: виберіть «longest»</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>the channel did not move during the record; leave it out</source>
            <translation>канал не змінювався під час запису; не беріть його</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>these move together; leave one out or lower the order</source>
            <translation>ці канали змінюються разом; приберіть один або зменште порядок</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>{name}: {value} +- {spread} {unit} (k = 1) is not told from zero; the regression on it removes noise only</source>
            <translation>{name}: {value} +- {spread} {unit} (k = 1) не відрізняється від нуля; регресія за ним прибирає лише шум</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>channel {name} has values that are not finite; choose another</source>
            <translation>канал {name} містить нескінченні значення; виберіть інший</translation>
        </message>
        <message>
            <location filename="../../core/allan/deviation.py" />
            <source>the sampling rate must be positive, not {rate}</source>
            <translation>частота дискретизації має бути додатною, а не {rate}</translation>
        </message>
        <message>
            <location filename="../../core/allan/deviation.py" />
            <source>the Allan deviation at tau = {rate} s is zero: the samples repeat exactly (a synthetic or stuck record)</source>
            <translation>девіація Аллана при tau = {rate} s дорівнює нулю: відліки точно повторюються (штучний або завислий запис)</translation>
        </message>
        <message>
            <location filename="../../core/allan/faults.py" />
            <source>{longest} samples in succession are equal, where at most {expected} could be expected: the channel was stuck for a time</source>
            <translation>{longest} [відлік|відліки|відліків] поспіль однакові, тоді як очікувати можна щонайбільше {expected}: канал на якийсь час завис</translation>
        </message>
        <message>
            <location filename="../../core/allan/faults.py" />
            <source>{piled} samples lie exactly at the extreme value {extreme}, but only {beside} at the value beside it: the signal is clipped, noise is understated</source>
            <translation>{piled} [відлік|відліки|відліків] лежать точно на крайньому значенні {extreme}, а поруч із ним лише {beside}: сигнал обмежений, шум занижено</translation>
        </message>
        <message>
            <location filename="../../core/allan/leastsquares.py" />
            <source>{len} points of the Allan curve lie between {shortest} s and a third of the record; {len2} terms need more: record longer</source>
            <translation>{len} [точка|точки|точок] кривої Аллана лежать між {shortest} s і третиною запису; для {len2} складових потрібно більше: записуйте довше</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the noise is not flat up to {top} Hz (a filter in the sensor, a resonance, vibration); frequencies up to {band} Hz and tau from {band2} s were fitted</source>
            <translation>шум не є рівним до {top} Hz (фільтр у датчику, резонанс, вібрація); оцінено за частотами до {band} Hz і tau від {band2} s</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the record drifts steadily by {value} +- {ramp} {unit_of} (k = 1); it was taken off before the noise was fitted. Was the sensor warmed up?</source>
            <translation>запис рівномірно дрейфує на {value} +- {ramp} {unit_of} (k = 1); дрейф вилучено перед оцінкою шуму. Чи був датчик прогрітий?</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>a noise fit needs one stretch without gaps: choose 'longest'</source>
            <translation>оцінка шуму потребує однієї ділянки без пропусків: виберіть «longest»</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>{found} samples without a gap: the noise terms cannot be told apart in fewer than {shortest}; record longer</source>
            <translation>{found} [відлік|відліки|відліків] без пропусків: складові шуму не розрізнити менш ніж за {shortest}; записуйте довше</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the spectrum is {ratio} times the fitted noise about {frequency} Hz (period {frequency2} s): vibration, a thermostat or a warm-up rather than noise</source>
            <translation>спектр у {ratio} [раз|раза|разів] перевищує оцінений шум поблизу {frequency} Hz (період {frequency2} s): радше вібрація, термостат або прогрів, ніж шум</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the spectrum has another shape than white, flicker and random walk noise together; the intervals are too narrow</source>
            <translation>спектр має іншу форму, ніж білий шум, флікер-шум і випадкове блукання разом; інтервали завузькі</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>{symbol} is {value} {unit} by likelihood but {value2} by least squares of the Allan variance, {abs} standard uncertainties apart: trust neither before the spectrum was looked at</source>
            <translation>{symbol} дорівнює {value} {unit} за правдоподібністю, але {value2} за найменшими квадратами дисперсії Аллана, різниця {abs} стандартних невизначеностей: не довіряйте жодному, доки не переглянуто спектр</translation>
        </message>
        <message>
            <location filename="../../core/allan/other.py" />
            <source>these deviations need one stretch without gaps: choose 'longest'</source>
            <translation>ці девіації потребують однієї ділянки без пропусків: виберіть «longest»</translation>
        </message>
        <message>
            <location filename="../../core/allan/other.py" />
            <source>the {kind} deviation is offered up to {most} samples, the record has {x}: average neighbouring samples first</source>
            <translation>девіація {kind} доступна до {most} [відліку|відліків|відліків], у записі їх {x}: спершу усередніть сусідні відліки</translation>
        </message>
        <message>
            <location filename="../../core/allan/other.py" />
            <source>Hadamard, modified and total deviations need the optional package AllanTools: pip install "calrig[allan]"</source>
            <translation>девіації Адамара, модифікована і повна потребують додаткового пакета AllanTools: pip install "calrig[allan]"</translation>
        </message>
        <message>
            <location filename="../../core/allan/preview.py" />
            <source>the preview needs a model with a random walk N above zero</source>
            <translation>для попереднього перегляду потрібна модель із випадковим блуканням N більшим за нуль</translation>
        </message>
        <message>
            <location filename="../../core/allan/preview.py" />
            <source>a record of {duration} s holds no spectrum up to {top} Hz</source>
            <translation>запис тривалістю {duration} s не містить спектра до {top} Hz</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>{lost} samples were lost; only the longest gap-free stretch is analysed: {int} of {x} samples</source>
            <translation>втрачено відліків: {lost}; аналізується лише найдовша ділянка без пропусків: {int} з {x} [відліку|відліків|відліків]</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>{lost} samples were lost; the differences within {len} gap-free stretches are pooled, the longest has {int} samples</source>
            <translation>втрачено відліків: {lost}; об'єднано різниці всередині {len} [ділянки|ділянок|ділянок] без пропусків, найдовша має {int} [відлік|відліки|відліків]</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>the record has {len} time stamps; record longer</source>
            <translation>запис має {len} [позначку|позначки|позначок] часу; записуйте довше</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>time does not increase at sample {at} ({time} s, then {time2} s; {len} such places): the file is damaged or two runs were joined</source>
            <translation>час не зростає на відліку {at} ({time} s, потім {time2} s; таких місць {len}): файл пошкоджено або з'єднано дві серії</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>samples are not uniform in time: {jumps} % of the steps are longer than the usual {middle} s. Are these arrival times of bursts? Use the device's counter</source>
            <translation>відліки нерівномірні в часі: {jumps} % кроків довші за звичайні {middle} s. Це час надходження пакетів? Скористайтеся лічильником пристрою</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>samples are not uniform in time: sample {worst} at {time} s is {off} of the interval {interval} s off the grid; use the device's counter as the time axis, or resample</source>
            <translation>відліки нерівномірні в часі: відлік {worst} на {time} s зміщений на {off} інтервалу {interval} s від сітки; візьміть лічильник пристрою як вісь часу або перерахуйте відліки</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>a record is one-dimensional, not {shape}</source>
            <translation>запис має бути одновимірним, а не {shape}</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>the record has {counted} usable samples: an Allan curve needs at least {shortest_record}; record longer</source>
            <translation>запис має {counted} придатних відліків: крива Аллана потребує щонайменше {shortest_record}; записуйте довше</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>all {count} samples equal {lowest}: the channel is stuck or not connected</source>
            <translation>усі {count} [відлік|відліки|відліків] дорівнюють {lowest}: канал завис або не під'єднаний</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>the record has gaps: {lost} samples lost, the first after sample {first} of {x}; analyse the longest gap-free stretch, or pool the stretches</source>
            <translation>запис має пропуски: втрачено відліків {lost}, перший після відліку {first} з {x}; аналізуйте найдовшу ділянку без пропусків або об'єднайте ділянки</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>{len} sample numbers for {x} samples</source>
            <translation>{len} [номер|номери|номерів] відліків на {x} [відлік|відліки|відліків]</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>sample numbers do not increase at sample {at}: two runs were joined</source>
            <translation>номери відліків не зростають на відліку {at}: з'єднано дві серії</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>{count} samples so far: an Allan curve needs {shortest_record}</source>
            <translation>поки що {count} [відлік|відліки|відліків]: крива Аллана потребує {shortest_record}</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>no stretch without lost samples is long enough; check the link</source>
            <translation>жодна ділянка без втрачених відліків не є достатньо довгою; перевірте зв'язок</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>all {count} samples so far are equal: the channel is stuck or not connected</source>
            <translation>усі {count} [відлік|відліки|відліків] досі однакові: канал завис або не під'єднаний</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>factor {step} is not a multiple of its stride {stride}</source>
            <translation>множник {step} не кратний кроку {stride}</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>{cuts} gaps so far; no difference is taken across them</source>
            <translation>пропусків досі: {cuts}; різниці через них не беруться</translation>
        </message>
        <message>
            <location filename="../../core/allan/taus.py" />
            <source>the record has {x} samples: an Allan curve needs at least {shortest_record}; record longer</source>
            <translation>запис має {x} [відлік|відліки|відліків]: крива Аллана потребує щонайменше {shortest_record}; записуйте довше</translation>
        </message>
        <message>
            <location filename="../../core/allan/whittle.py" />
            <source>the likelihood has no upper limit: the record does not determine the term</source>
            <translation>правдоподібність не має верхньої межі: запис не визначає цю складову</translation>
        </message>
        <message>
            <location filename="../../core/allan/whittle.py" />
            <source>the spectrum of the record is zero within the band; is the record stuck?</source>
            <translation>спектр запису дорівнює нулю в межах смуги; чи не завис запис?</translation>
        </message>
        <message>
            <location filename="../../core/allan/whittle.py" />
            <source>no noise model fits the spectrum up to {limit} Hz: the record is too short, or it holds something that is not noise (motion, mains, a step)</source>
            <translation>жодна модель шуму не підходить до спектра до {limit} Hz: запис закороткий або містить щось, що не є шумом (рух, мережа живлення, стрибок)</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>they are of different devices, {serial} and {serial2}</source>
            <translation>вони від різних пристроїв, {serial} і {serial2}</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>in different units, not compared: {join}</source>
            <translation>у різних одиницях, не порівнюються: {join}</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>{alone} parameters stand in one of them only</source>
            <translation>{alone} [параметр|параметри|параметрів] є лише в одному з них</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>they were measured {apart} K apart ({temperature_c} and {temperature_c2} °C): a part of the differences is temperature</source>
            <translation>їх виміряно з різницею {apart} K ({temperature_c} і {temperature_c2} °C): частина різниць зумовлена температурою</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>they have no parameter in common</source>
            <translation>спільних параметрів немає</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>the files of the sessions are untouched</source>
            <translation>файли сеансів не зачеплено</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the database of the archive refuses ({said}); {safe}</source>
            <translation>{name}: база даних архіву відмовляє ({said}); {safe}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: another program has been writing to it for {wait_s} s; try again</source>
            <translation>{name}: інша програма записує в нього вже {wait_s} s; спробуйте ще раз</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the index is damaged ({said}); {safe}: open the archive again</source>
            <translation>{name}: індекс пошкоджено ({said}); {safe}: відкрийте архів знову</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: cannot be written ({said}); {safe}</source>
            <translation>{name}: неможливо записати ({said}); {safe}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the disk is full; {safe}: free some space, then refresh</source>
            <translation>{name}: диск заповнено; {safe}: звільніть місце, потім оновіть</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>disk I/O</source>
            <translation>disk I/O</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the disk is full or does not answer ({said}); {safe}: free some space or connect it again, then refresh</source>
            <translation>{name}: диск заповнено або не відповідає ({said}); {safe}: звільніть місце або під'єднайте його знову, потім оновіть</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{get_backend_name}: the archive knows postgresql and sqlite</source>
            <translation>{get_backend_name}: архів знає postgresql і sqlite</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>disk is full</source>
            <translation>диск заповнено</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>No space</source>
            <translation>немає місця</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>BEGIN IMMEDIATE</source>
            <translation>BEGIN IMMEDIATE</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>the index was damaged; it is kept as {name} and a new one is made from the files, which are untouched</source>
            <translation>індекс було пошкоджено; його збережено як {name}, а новий створено з файлів, які не зачеплено</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{root} may not be written to: its index is kept until the program ends</source>
            <translation>у {root} не можна записувати: індекс зберігається до завершення програми</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: this archive was made by a newer CalRig (schema {found}; this program knows {version}): it is shown and not changed; update CalRig</source>
            <translation>{name}: цей архів створено новішою версією CalRig (схема {found}; ця програма знає {version}): його показано без змін; оновіть CalRig</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>the address of the database is none; expected postgresql://USER@HOST/DATABASE, or nothing for a file beside the sessions</source>
            <translation>адреса бази даних неправильна; очікується postgresql://USER@HOST/DATABASE або нічого для файла поруч із сеансами</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: needs the PostgreSQL driver: pip install "calrig[postgres]"</source>
            <translation>{name}: потрібен драйвер PostgreSQL: pip install "calrig[postgres]"</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>malformed text: {error}</source>
            <translation>пошкоджений текст: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>not a database</source>
            <translation>не база даних</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>file is encrypted</source>
            <translation>файл зашифровано</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>PRAGMA quick_check(1)</source>
            <translation>PRAGMA quick_check(1)</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>malformed: {said}</source>
            <translation>пошкоджено: {said}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{one}: damaged, and cannot be set aside ({strerror}): close other programs that use it and try again</source>
            <translation>{one}: пошкоджено, і його не вдається відкласти ({strerror}): закрийте інші програми, що ним користуються, і спробуйте знову</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>{other_units} earlier values are in another unit than {unit} and are left out</source>
            <translation>{other_units} попередніх значень в інших одиницях, ніж {unit}; їх пропущено</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>{bad} calibrations with errors are shown and do not count</source>
            <translation>{bad} [калібрування|калібрування|калібрувань] з помилками показано, але не враховано</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>{far} calibrations not at about {temperature_c} °C are shown and do not count</source>
            <translation>{far} [калібрування|калібрування|калібрувань] не поблизу {temperature_c} °C показано, але не враховано</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>a history of nothing</source>
            <translation>немає з чого скласти історію</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>already there</source>
            <translation>вже є</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>not known</source>
            <translation>невідомий</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{kind} of {join}</source>
            <translation>{kind} з {join}</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: a thousand files of the name {name}</source>
            <translation>{folder}: тисяча файлів з назвою {name}</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: there is no such folder</source>
            <translation>{folder}: такої теки немає</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: lies in the archive itself; what is in it is found there</source>
            <translation>{folder}: лежить у самому архіві; те, що в ній, знаходять там</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: holds the archive itself: name the folders beside it</source>
            <translation>{folder}: містить сам архів: укажіть теки поруч із ним</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>no kind of file that is archived</source>
            <translation>не той вид файла, що архівується</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>what was imported before stays</source>
            <translation>те, що імпортовано раніше, залишається</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>pass: the value and its expanded uncertainty (95 %) lie within the limits; fail: both lie beyond one; otherwise undecided (JCGM 106, guard band w = U)</source>
            <translation>відповідає: значення та його розширена невизначеність (95 %) лежать у межах; не відповідає: обидва за межею; інакше не вирішено (JCGM 106, захисна смуга w = U)</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>limit {number}</source>
            <translation>межа {number}</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>holds something else than [[limit]] tables</source>
            <translation>містить щось інше, ніж таблиці [[limit]]</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where} is no table: write [[limit]]</source>
            <translation>{where} не є таблицею: пишіть [[limit]]</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where}: {join} is not known</source>
            <translation>{where}: {join} невідоме</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where}: {join} are texts</source>
            <translation>{where}: {join} є текстами</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where} names no parameter</source>
            <translation>{where} не називає параметра</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where} needs a number as low, as high, or as both</source>
            <translation>{where} потребує числа як low, як high або обох</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where}: low must lie below high</source>
            <translation>{where}: low має бути нижче high</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>is no TOML: {error}</source>
            <translation>не TOML: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>the same day</source>
            <translation>того самого дня</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>No. {id}, {when}, {warmth} °C</source>
            <translation>№ {id}, {when}, {warmth} °C</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>No. {id}, {when}</source>
            <translation>№ {id}, {when}</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>one day earlier</source>
            <translation>на один день раніше</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>one day later</source>
            <translation>на один день пізніше</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>{count} days earlier</source>
            <translation>на {count} [день|дні|днів] раніше</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>{count} days later</source>
            <translation>на {count} [день|дні|днів] пізніше</translation>
        </message>
        <message>
            <location filename="../../core/archive/noise_file.py" />
            <source>is no table: {error}</source>
            <translation>не є таблицею: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/noise_file.py" />
            <source>no line of coefficients: {error}</source>
            <translation>немає рядка коефіцієнтів: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/place.py" />
            <source>{root}: there is no such folder; nothing is changed: connect the disk, or name the folder of your sessions</source>
            <translation>{root}: такої теки немає; нічого не змінено: під'єднайте диск або вкажіть теку ваших сеансів</translation>
        </message>
        <message>
            <location filename="../../core/archive/place.py" />
            <source>id is empty</source>
            <translation>id порожній</translation>
        </message>
        <message>
            <location filename="../../core/archive/reading.py" />
            <source>is too large for a table of means</source>
            <translation>завеликий для таблиці середніх</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>its raw bytes were not recorded</source>
            <translation>його необроблені байти не записано</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>its raw log {name} is not there</source>
            <translation>його необробленого журналу {name} немає</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>its bytes hold no samples</source>
            <translation>його байти не містять відліків</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>holds the samples {index} to {index2}, and {first} was accumulated</source>
            <translation>містить відліки від {index} до {index2}, а накопичено було {first}</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>today's decoder names none of its channels</source>
            <translation>сьогоднішній декодер не називає жодного з його каналів</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>{root}: another archive stands there now; nothing is changed: open the archive anew</source>
            <translation>{root}: тепер там інший архів; нічого не змінено: відкрийте архів знову</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>the archive holds nothing of the number {number}: list it anew</source>
            <translation>в архіві немає нічого з номером {number}: оновіть список</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>{path} stands at the rig {name}, in its folder {path2}</source>
            <translation>{path} лежить на стенді {name}, у його теці {path2}</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>{path}: is no longer there; refresh the archive</source>
            <translation>{path}: більше не існує; оновіть архів</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>contact of the customer</source>
            <translation>контакт замовника</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>serial number of the item</source>
            <translation>заводський номер виробу</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>condition of the item</source>
            <translation>стан виробу</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>date of calibration</source>
            <translation>дата калібрування</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>date of issue</source>
            <translation>дата видачі</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>ambient temperature</source>
            <translation>температура довкілля</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>uncertainty of the results</source>
            <translation>невизначеність результатів</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>what was changed, and why</source>
            <translation>що змінено і чому</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>{name}: "{text}" is no date; write it as 2026-03-31</source>
            <translation>{name}: «{text}» не є датою; пишіть як 2026-03-31</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>{later} on {other}, before it was {name} on {text}</source>
            <translation>{later} {other}, раніше за {name} {text}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/conformity_json.py" />
            <source>pass, fail or undecided</source>
            <translation>відповідає, не відповідає або не вирішено</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>name of the laboratory</source>
            <translation>назва лабораторії</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>address of the laboratory</source>
            <translation>адреса лабораторії</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>person who authorises</source>
            <translation>особа, що затверджує</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>standards and their traceability</source>
            <translation>еталони та їх простежуваність</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>{name}: "{valid_until}" is no date; write it as 2026-03-31</source>
            <translation>{name}: «{valid_until}» не є датою; пишіть як 2026-03-31</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>not stated: {words}; what does not apply stays an empty text</source>
            <translation>не вказано: {words}; що не стосується, лишається порожнім текстом</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>the pattern {number} has no n</source>
            <translation>шаблон {number} не має n</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>{name}: its certificate was valid until {until}, not on {day}</source>
            <translation>{name}: його сертифікат був дійсний до {until}, а не на {day}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>a text</source>
            <translation>текст</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>the pattern {number} cannot be filled</source>
            <translation>шаблон {number} неможливо заповнити</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>{name}: no certificate is named, so that nothing can be traced</source>
            <translation>{name}: сертифіката не названо, тож простежити нічого неможливо</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory_file.py" />
            <source>{path}: is there already, and is not written over; name another file</source>
            <translation>{path}: вже є і не перезаписується; назвіть інший файл</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory_file.py" />
            <source>is not there; the window keeps it beside the sessions, and calrig certificate --template laboratory.toml writes one to be filled in</source>
            <translation>немає; вікно тримає його поруч із сеансами, а calrig certificate --template laboratory.toml пише такий для заповнення</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory_file.py" />
            <source>not known: {join}; known are {join2}, and of [[standards]] {join3}</source>
            <translation>невідомо: {join}; відомі {join2}, а для [[standards]] {join3}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/order_file.py" />
            <source>a number above zero</source>
            <translation>число більше нуля</translation>
        </message>
        <message>
            <location filename="../../core/certificates/order_file.py" />
            <source>{where}: {key} is not known; known are {join}</source>
            <translation>{where}: {key} невідомий; відомі {join}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{folder}: no number is free after {attempts} attempts</source>
            <translation>{folder}: після {attempts} [спроби|спроб|спроб] немає вільного номера</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{twin}: there is no such certificate</source>
            <translation>{twin}: такого сертифіката немає</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{path}: the certificate was withdrawn before</source>
            <translation>{path}: сертифікат уже відкликано</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{path}: cannot be written ({strerror})</source>
            <translation>{path}: неможливо записати ({strerror})</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{path}: the certificate cannot be kept ({strerror})</source>
            <translation>{path}: сертифікат неможливо зберегти ({strerror})</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/advise.py" />
            <source>{why}; tells apart {join}</source>
            <translation>{why}; розрізняє {join}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Where they differ most, {len} positions</source>
            <translation>Де вони різняться найбільше, положень: {len}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>angles at which the tied effects read most differently, each twice, in mixed order</source>
            <translation>кути, за яких нерозрізнені ефекти дають найрізніші покази, кожен двічі, у змішаному порядку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>All mountings twice, twice as dense</source>
            <translation>Усі встановлення двічі, удвічі густіше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rig, dial and sensor apart, and marks between those of the first plan</source>
            <translation>стенд, шкала і датчик окремо, і позначки між тими, що в першому плані</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Reversed sweep</source>
            <translation>Прохід у зворотному напрямі</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same angles the other way round</source>
            <translation>ті самі кути в зворотному порядку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Mixed sweep</source>
            <translation>Прохід упереміш</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same angles in mixed order</source>
            <translation>ті самі кути у змішаному порядку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Unit re-indexed by 90 deg</source>
            <translation>Виріб повернуто на 90 deg</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the dial errs at other attitudes</source>
            <translation>шкала має похибки в інших положеннях</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Unit end for end</source>
            <translation>Виріб кінцями навпаки</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>errors of the rig turn their sign</source>
            <translation>похибки стенда змінюють знак</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Back to the first mounting</source>
            <translation>Назад до першого встановлення</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>what goes with time is not what came by bolting</source>
            <translation>те, що змінюється з часом, — не те, що прийшло від закріплення</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>End for end, and re-indexed</source>
            <translation>Кінцями навпаки і з поворотом</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rig, dial and sensor apart</source>
            <translation>стенд, шкала і датчик окремо</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>All mountings, mixed</source>
            <translation>Усі встановлення, упереміш</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>All mountings twice, mixed</source>
            <translation>Усі встановлення двічі, упереміш</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rig, dial and sensor apart, with half the noise</source>
            <translation>стенд, шкала і датчик окремо, з удвічі меншим шумом</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Mixed rates</source>
            <translation>Швидкості упереміш</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same rates in mixed order</source>
            <translation>ті самі швидкості у змішаному порядку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Mixed rates twice</source>
            <translation>Швидкості упереміш двічі</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same rates in mixed order, twice</source>
            <translation>ті самі швидкості у змішаному порядку, двічі</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Falling rates</source>
            <translation>Спадні швидкості</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same rates downwards</source>
            <translation>ті самі швидкості за спаданням</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Rates between</source>
            <translation>Проміжні швидкості</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rates between those that were measured</source>
            <translation>швидкості між уже виміряними</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Small rates</source>
            <translation>Малі швидкості</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rates close to zero</source>
            <translation>швидкості поблизу нуля</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>{axis} along the shaft</source>
            <translation>{axis} вздовж вала</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>another cross axis is vertical</source>
            <translation>вертикальною є інша поперечна вісь</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>These rows cannot tell: {why}.</source>
            <translation>Ці рядки не дають відповіді: {why}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>{shape} rows for {shape2} parameters leave nothing that could contradict the model; measure more positions, and each twice</source>
            <translation>{shape} [рядок|рядки|рядків] на {shape2} [параметр|параметри|параметрів] не залишають нічого, що могло б суперечити моделі; виміряйте більше положень, і кожне двічі</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>these rows cannot show {identifier}</source>
            <translation>ці рядки не можуть показати {identifier}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>any further effect</source>
            <translation>будь-який подальший ефект</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>{channels}: {len} rows for the {shape} parameters of the plain model; add positions</source>
            <translation>{channels}: {len} [рядок|рядки|рядків] на {shape} [параметр|параметри|параметрів] простої моделі; додайте положення</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>a run of test {test} is not compared; {join} are</source>
            <translation>серія випробування {test} не порівнюється; порівнюються {join}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>row {row}, {channels}: the output is not a number; leave the row out or measure it again</source>
            <translation>рядок {row}, {channels}: вихід не є числом; вилучіть рядок або виміряйте його знову</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>local gravity is not stated; {x} m/s^2 is taken, which changes the scale factor alone</source>
            <translation>місцеве g не вказано; взято {x} m/s^2, що змінює лише масштабний коефіцієнт</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>{name} is left out: its own input never changes in these rows; add positions</source>
            <translation>{name} пропущено: його власний вхід у цих рядках не змінюється; додайте положення</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>{channels}: the input along {axis} does not change; add positions</source>
            <translation>{channels}: вхід уздовж {axis} не змінюється; додайте положення</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>The gap goes from {gap} to {gap2} noise floors.</source>
            <translation>Розбіжність зменшується з {gap} до {gap2} рівнів шуму.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>there is no output {channel}; there are: {join}</source>
            <translation>виходу {channel} немає; є: {join}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>A constant explains the record; its scatter is {scatter}.</source>
            <translation>Запис пояснює стала; її розкид {scatter}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>No effect stands out, but the bias wanders far more than in sensors of this kind: it is {scatter}, or something that the catalogue does not know.</source>
            <translation>Жоден ефект не виділяється, але зміщення нуля блукає значно більше, ніж у датчиків цього виду: це {scatter} або щось, чого каталог не знає.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>Missing in the model: {named}. {closing} The rest is {scatter}.</source>
            <translation>У моделі бракує: {named}. {closing} Решта — {scatter}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>The data are at fault: {named}. The rest is {scatter}.</source>
            <translation>Винні дані: {named}. Решта — {scatter}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>Something is missing, and this record cannot tell which of several effects: {tied}. {closing}</source>
            <translation>Чогось бракує, і цей запис не вирішує, якого з кількох ефектів: {tied}. {closing}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>a run of test {test} is no record</source>
            <translation>серія випробування {test} не є записом</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>with {lower}</source>
            <translation>з {lower}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>the noise floor is from the record itself: noise slower than a part of the record is known from sensors of this kind only</source>
            <translation>рівень шуму взято з самого запису: шум, повільніший за частину запису, відомий лише з датчиків цього виду</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>This record cannot tell: {why}.</source>
            <translation>Цей запис не дає відповіді: {why}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>There is structure that no effect of the catalogue explains:</source>
            <translation>Є структура, якої не пояснює жоден ефект каталогу:</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>the bias wanders several times as much as in sensors of this kind: noise of this unit, or a cause that is not in the catalogue; a second record tells, for noise goes another way then</source>
            <translation>зміщення нуля блукає в кілька разів більше, ніж у датчиків цього виду: шум цього виробу або причина, якої немає в каталозі; це покаже другий запис, бо шум тоді піде інакше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>named, not yet confirmed: only another record, with temperature and time going otherwise, confirms it</source>
            <translation>названо, ще не підтверджено: підтвердить лише інший запис, у якому температура і час ідуть інакше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{lost} of {int} samples never came, in {int2} gaps of up to {longest} s</source>
            <translation>{lost} з {int} [відліку|відліків|відліків] не прийшли, у {int2} пропусках до {longest} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{int} samples in succession are equal to the last bit, from {at} s on</source>
            <translation>{int} [відлік|відліки|відліків] поспіль однакові до останнього біта, від {at} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{int} codes of {bit} {unit} never occur, where about {mean} samples each were to be expected</source>
            <translation>{int} [код|коди|кодів] по {bit} {unit} ніколи не трапляються, де очікувалося близько {mean} [відліку|відліків|відліків] на кожен</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>the scatter is {ratio} times as large as elsewhere in {len} stretches, the first from {rows} s on</source>
            <translation>розкид у {ratio} [раз|раза|разів] більший, ніж деінде, на {len} ділянках, перша від {rows} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{len} samples lie off, the farthest by {rest} sigma at {t_s} s</source>
            <translation>{len} [відлік|відліки|відліків] випадають, найдалі на {rest} сигм при {t_s} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>the temperature is {value} degC to the last bit in {int} samples in succession from {at} s on</source>
            <translation>температура дорівнює {value} °C до останнього біта в {int} відліках поспіль від {at} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Another record right behind this one</source>
            <translation>Ще один запис одразу за цим</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>what settles has settled then, what drifts goes on, what jumped stays</source>
            <translation>те, що встановлюється, тоді вже встановилося, те, що дрейфує, триває, те, що стрибнуло, лишається</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Restart from cold</source>
            <translation>Запуск із холодного стану</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>what settles after switching on begins anew, what drifts goes on</source>
            <translation>те, що встановлюється після увімкнення, почнеться знову, те, що дрейфує, триватиме</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Temperature held after a warm-up of an hour</source>
            <translation>Стала температура після години прогріву</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>nothing that goes with temperature or with switching on is left</source>
            <translation>не лишається нічого, що йде за температурою чи увімкненням</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Temperature up and down by {span_c} degC at {rate} degC/min</source>
            <translation>Температура вгору і вниз на {span_c} °C зі швидкістю {rate} °C/min</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>both directions and a rest between tell lag, hysteresis, slope and time apart</source>
            <translation>обидва напрями з паузою між ними розрізняють запізнення, гістерезис, нахил і час</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Drive amplitude {drive} % higher for a third of the record</source>
            <translation>Амплітуда збудження на {drive} % більша протягом третини запису</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>what goes with the drive steps, what goes with temperature or time does not</source>
            <translation>те, що йде за збудженням, стрибне, а те, що йде за температурою чи часом, — ні</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>as before</source>
            <translation>як раніше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>on, temperature held</source>
            <translation>увімкнено, температура стала</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>temperature held</source>
            <translation>температура стала</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>up by {span_c} degC</source>
            <translation>вгору на {span_c} °C</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>down by {span_c} degC</source>
            <translation>вниз на {span_c} °C</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>{name}, {minutes} min</source>
            <translation>{name}, {minutes} min</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>amplitude as it is</source>
            <translation>амплітуда без змін</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>{len} blocks of {size} samples hold enough samples; record longer</source>
            <translation>{len} [блок|блоки|блоків] по {size} відліків вміщують досить; записуйте довше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>{len} samples are no record; record at least {fewest_samples}</source>
            <translation>{len} [відлік|відліки|відліків] — не запис; запишіть щонайменше {fewest_samples}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>the times of some rows are missing; state the samples per second</source>
            <translation>у деяких рядках немає часу; вкажіть кількість відліків за секунду</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>time runs backwards at sample {at}: two records were joined, take one</source>
            <translation>час іде назад на відліку {at}: з'єднано два записи, візьміть один</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>the samples are not uniform in time; use the counter of the device, or resample</source>
            <translation>відліки нерівномірні в часі; скористайтеся лічильником пристрою або перерахуйте відліки</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>only {int} samples of {channels} are numbers</source>
            <translation>лише {int} [відлік|відліки|відліків] {channels} є числами</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>all samples of {channels} are equal: it is stuck or not connected</source>
            <translation>усі відліки {channels} однакові: канал завис або не під'єднаний</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>any effect of a record</source>
            <translation>будь-який ефект запису</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>any effect of time</source>
            <translation>будь-який ефект часу</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/row_facts.py" />
            <source>all {len} rows of {minutes} min have the same temperature to the last digit, {values} degC: it does not come from the thermometer of the unit; effects of temperature cannot be judged</source>
            <translation>усі {len} [рядок|рядки|рядків] за {minutes} min мають температуру {values} °C, однакову до останньої цифри: вона не з термометра виробу; ефекти температури оцінити не можна</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>there is structure in {name} that no effect of the catalogue explains</source>
            <translation>у {name} є структура, якої не пояснює жоден ефект каталогу</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>{text}: the output goes to and fro between two levels, {abs} {unit} apart, {changes} times</source>
            <translation>{text}: вихід переходить між двома рівнями з різницею {abs} {unit}, переходів: {changes}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>look at the rig and the sensor where the curve is largest</source>
            <translation>огляньте стенд і датчик там, де крива найбільша</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>measure more densely where the curve is largest</source>
            <translation>вимірюйте густіше там, де крива найбільша</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>{text}: a smooth curve of {size} {unit} rms describes it, largest ({curve} {unit2}) at {worst} {unit3}</source>
            <translation>{text}: її описує гладка крива із СКВ {size} {unit}, найбільша ({curve} {unit2}) при {worst} {unit3}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>a smooth curve</source>
            <translation>гладка крива</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>two levels</source>
            <translation>два рівні</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>The model explains the data: the gap is {gap} noise floors. What these rows could have shown is listed.</source>
            <translation>Модель пояснює дані: розбіжність {gap} рівнів шуму. Те, що ці рядки могли б показати, перелічено.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>Missing in the model: {named}. {closing}</source>
            <translation>У моделі бракує: {named}. {closing}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>The data are at fault: {named}. {closing}</source>
            <translation>Винні дані: {named}. {closing}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>No effect stands out, but the noise is {gap} times what is stated, or a part of it is.</source>
            <translation>Жоден ефект не виділяється, але шум у {gap} [раз|раза|разів] більший за вказаний, або його частина.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>the noise floor is from {told}; measure every position twice</source>
            <translation>рівень шуму взято з {told}; виміряйте кожне положення двічі</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>the part {name} of the noise is {ratio} times what is stated or usual</source>
            <translation>складова шуму {name} у {ratio} [раз|раза|разів] більша за вказану або звичайну</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>a wrong value of g, a common error of all angles and a tilt seen through one mounting alone hide in scale factor, misalignment and bias; no number of rows shows them</source>
            <translation>неправильне значення g, спільна похибка всіх кутів і нахил, видимий лише в одному встановленні, ховаються в масштабному коефіцієнті, неспіввісності та зміщенні нуля; жодна кількість рядків їх не покаже</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>an error of the table's speed in proportion to the rate hides in the scale factor; only its period shows it</source>
            <translation>похибка швидкості стенда, пропорційна швидкості, ховається в масштабному коефіцієнті; її покаже лише період обертання</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>temperatures count from {mean} degC</source>
            <translation>температури відлічуються від {mean} °C</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>named, not yet confirmed: only a new series with other angles or order confirms it</source>
            <translation>названо, але ще не підтверджено: підтвердить лише нова серія з іншими кутами або порядком</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>Something is missing, and these data cannot tell which of several effects:</source>
            <translation>Чогось бракує, і ці дані не вирішують, якого з кількох ефектів:</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>standard errors and certificates, not from replicates</source>
            <translation>стандартних похибок і сертифікатів, не з повторень</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>the residuals alone, for neither replicates nor standard errors are there</source>
            <translation>самих залишків, бо немає ні повторень, ні стандартних похибок</translation>
        </message>
        <message>
            <location filename="../../core/errors.py" />
            <source>not determined: {join}; {why}</source>
            <translation>не визначено: {join}; {why}</translation>
        </message>
        <message>
            <location filename="../../core/fit/design.py" />
            <source>the input that {which} respond to is not known in every row</source>
            <translation>вхід, на який реагують {which}, відомий не в кожному рядку</translation>
        </message>
        <message>
            <location filename="../../core/fit/design.py" />
            <source>{x} rows of these positions determine {rank} of {x2} parameters; measure positions in which the missing axes change, or fit fewer parameters</source>
            <translation>{x} [рядок|рядки|рядків] цих положень визначають {rank} з {x2} [параметра|параметрів|параметрів]; виміряйте положення, у яких змінюються відсутні осі, або оцінюйте менше параметрів</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>the uncertainties allow for it; the unit drifts between accumulations, positions were set worse than stated, or the model lacks something</source>
            <translation>невизначеності це враховують; виріб дрейфує між накопиченнями, положення встановлено гірше, ніж указано, або моделі чогось бракує</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>all uncertainties were enlarged by that factor, and the model lacks something</source>
            <translation>усі невизначеності збільшено в стільки ж разів, і моделі чогось бракує</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>the residuals are {sqrt} times larger than the stated uncertainties of the rows allow (p = {p_value}); {meaning}</source>
            <translation>залишки у {sqrt} [раз|раза|разів] більші, ніж допускають указані невизначеності рядків (p = {p_value}); {meaning}</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>repeated positions agree to {pure_sd} but the model misses the means by more (F = {statistic}, p = {p_value}): the model lacks something</source>
            <translation>повторені положення збігаються в межах {pure_sd}, але модель відхиляється від середніх більше (F = {statistic}, p = {p_value}): моделі чогось бракує</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>only {told} of {x} rows bring a usable standard error; none is used, and the scatter of the residuals stands for all</source>
            <translation>лише {told} з {x} [рядка|рядків|рядків] мають придатну стандартну похибку; жодної не використано, за всі відповідає розкид залишків</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>{x} rows for {x2} parameters leave no residual that could show the drift between accumulations, and the intervals do not allow for it; repeat positions</source>
            <translation>{x} [рядок|рядки|рядків] на {x2} [параметр|параметри|параметрів] не залишають залишку, який показав би дрейф між накопиченнями, й інтервали його не враховують; повторіть положення</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>{x} rows for {x2} parameters leave no degree of freedom: the numbers have no uncertainty and nothing can contradict them; repeat positions</source>
            <translation>{x} [рядок|рядки|рядків] на {x2} [параметр|параметри|параметрів] не залишають ступеня вільності: числа не мають невизначеності, і ніщо не може їм суперечити; повторіть положення</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>row {bad}: the output is not a number</source>
            <translation>рядок {bad}: вихід не є числом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>the output does not vanish at zero input</source>
            <translation>вихід не зникає за нульового входу</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>how much the output changes per unit of input</source>
            <translation>наскільки змінюється вихід на одиницю входу</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>k_i * input_i</source>
            <translation>k_i * input_i</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>Cross-axis sensitivity</source>
            <translation>Перехресна чутливість</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>the sensor also feels the two other axes, mostly because it stands askew</source>
            <translation>датчик відчуває і дві інші осі, здебільшого тому, що стоїть навскіс</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>k_ij * input_j + k_ik * input_k</source>
            <translation>k_ij * input_j + k_ik * input_k</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one accumulation was disturbed</source>
            <translation>одне накопичення було порушене</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>e at one row</source>
            <translation>e в одному рядку</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one row lies off</source>
            <translation>один рядок випадає</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>look at the raw samples of this row; measure it again</source>
            <translation>перегляньте необроблені відліки цього рядка; виміряйте його знову</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Wrong angle</source>
            <translation>Неправильний кут</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>the head stood at another angle than written</source>
            <translation>головка стояла на іншому куті, ніж записано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>U(angle + d) - U(angle) at one row</source>
            <translation>U(кут + d) - U(кут) в одному рядку</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one row lies off in all sensors, as one angle explains</source>
            <translation>один рядок випадає в усіх датчиках так, як це пояснює один кут</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>correct the angle if it is a whole step of the dial, else measure the row again</source>
            <translation>виправте кут, якщо це цілий крок шкали, інакше виміряйте рядок знову</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Wrong stop</source>
            <translation>Неправильна зупинка</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>at one position the head stood wrong in every run</source>
            <translation>в одному положенні головка щоразу стояла неправильно</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>U(angle + d) - U(angle) at one position</source>
            <translation>U(кут + d) - U(кут) в одному положенні</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>all rows of one position lie off alike</source>
            <translation>усі рядки одного положення випадають однаково</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>check the stop or the division of the head there</source>
            <translation>перевірте упор або поділку головки там</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Short accumulation</source>
            <translation>Коротке накопичення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one accumulation began too early or was too short</source>
            <translation>одне накопичення почалося зарано або було закоротким</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>rho * (U_previous - U) at one row</source>
            <translation>rho * (U_попереднє - U) в одному рядку</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one row lies off towards the row before, and its own scatter is large</source>
            <translation>один рядок відхиляється в бік попереднього, і його власний розкид великий</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>look at the raw samples; wait longer; measure the row again</source>
            <translation>перегляньте необроблені відліки; чекайте довше; виміряйте рядок знову</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Stuck reading</source>
            <translation>Завислий відлік</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>the reading of the row before was stored again, bit for bit</source>
            <translation>попередній відлік збережено знову, біт у біт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>a row that equals the row before exactly, at another setting</source>
            <translation>рядок точно дорівнює попередньому за іншого завдання</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>measure the row again</source>
            <translation>виміряйте рядок знову</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro.py" />
            <source>Acceleration-sensitive drift</source>
            <translation>Дрейф від прискорення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro.py" />
            <source>gravity and acceleration shift the zero of the gyro</source>
            <translation>сила тяжіння і прискорення зміщують нуль гіроскопа</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro.py" />
            <source>b_ix * a_x + b_iy * a_y + b_iz * a_z</source>
            <translation>b_ix * a_x + b_iy * a_y + b_iz * a_z</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>Magnetic sensitivity</source>
            <translation>Магнітна чутливість</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the magnetic field of the building shifts the output</source>
            <translation>магнітне поле будівлі зміщує вихід</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>m_s * (own axis along the shaft) + m_l * (own axis level across it)</source>
            <translation>m_s * (власна вісь уздовж вала) + m_l * (власна вісь горизонтально впоперек)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the harmonics of g-sensitivity, but fixed to the building</source>
            <translation>гармоніки g-чутливості, але прив'язані до будівлі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>turn the head by 180 degrees in azimuth; shield the unit</source>
            <translation>поверніть головку на 180 градусів за азимутом; екрануйте виріб</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>g-squared-sensitive drift</source>
            <translation>дрейф від квадрата g</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the square of the acceleration shifts the zero of the gyro</source>
            <translation>квадрат прискорення зміщує нуль гіроскопа</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>b_ij * a_i * a_j</source>
            <translation>b_ij * a_i * a_j</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>second harmonic of the head angle</source>
            <translation>друга гармоніка кута головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>measure between the quarter turns; calibrate with the products</source>
            <translation>вимірюйте між чвертями оберту; калібруйте з добутками</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>Earth rate</source>
            <translation>Обертання Землі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the gyro feels the rotation of the Earth</source>
            <translation>гіроскоп відчуває обертання Землі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>k * (W_up * up + W_north * north)</source>
            <translation>k * (W_верт * вгору + W_північ * північ)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>exactly what g-sensitivity looks like, as long as the head keeps its azimuth</source>
            <translation>точно так, як виглядає g-чутливість, доки головка зберігає азимут</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>compute it from the latitude; turn the head by 180 degrees in azimuth</source>
            <translation>обчисліть за широтою; поверніть головку на 180 градусів за азимутом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>the output depends on whether the input rose or fell before</source>
            <translation>вихід залежить від того, чи вхід перед тим зростав, чи спадав</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>k * h * sign(x - x_previous)</source>
            <translation>k * h * sign(x - x_попереднє)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>runs with rising and with falling input lie apart</source>
            <translation>серії зі зростанням і спаданням входу розходяться</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>approach all positions from one side, or state the two branches</source>
            <translation>підходьте до всіх положень з одного боку або вкажіть дві гілки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>Settling lag</source>
            <translation>Запізнення встановлення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>a part of the way from the position before is still missing</source>
            <translation>частини шляху від попереднього положення ще бракує</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>rho * (U_previous - U)</source>
            <translation>rho * (U_попереднє - U)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>residuals follow the step from the position before</source>
            <translation>залишки повторюють крок від попереднього положення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>wait longer before each accumulation</source>
            <translation>чекайте довше перед кожним накопиченням</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Second-order nonlinearity K2</source>
            <translation>Нелінійність другого порядку K2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the output bends the same way at both ends of the range</source>
            <translation>вихід вигинається однаково на обох кінцях діапазону</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a parabola against the input; second harmonic of the head angle</source>
            <translation>парабола залежно від входу; друга гармоніка кута головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the square term; on a rate table also try another radius</source>
            <translation>калібруйте з квадратичним членом; на поворотному стенді спробуйте також інший радіус</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Third-order nonlinearity K3</source>
            <translation>Нелінійність третього порядку K3</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the output bends in opposite ways at the two ends of the range</source>
            <translation>вихід вигинається протилежно на двох кінцях діапазону</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>an S against the input; third harmonic of the head angle</source>
            <translation>S-подібна залежність від входу; третя гармоніка кута головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the cubic term</source>
            <translation>калібруйте з кубічним членом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Odd quadratic nonlinearity</source>
            <translation>Непарна квадратична нелінійність</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the sensitivity grows with the size of the input, alike to both sides</source>
            <translation>чутливість зростає з величиною входу, однаково в обидва боки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * Ko * x * |x|</source>
            <translation>k * Ko * x * |x|</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>an S against the input that is steeper in the middle than a cube</source>
            <translation>S-подібна залежність від входу, крутіша посередині, ніж куб</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the term x|x|; more than 1 g tells it from the cube</source>
            <translation>калібруйте з членом x|x|; понад 1 g відрізняє його від куба</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Cross-axis nonlinearity Koo, Kpp</source>
            <translation>Поперечна нелінійність Koo, Kpp</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the square of the acceleration across the input axis shifts the output</source>
            <translation>квадрат прискорення впоперек вхідної осі зміщує вихід</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * (Kxx * a_x^2 + Kyy * a_y^2)</source>
            <translation>k * (Kxx * a_x^2 + Kyy * a_y^2)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the bias depends on which cross axis is vertical</source>
            <translation>зміщення нуля залежить від того, яка поперечна вісь вертикальна</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the square of the cross axis; mount another axis along the shaft</source>
            <translation>калібруйте з квадратом поперечної осі; встановіть іншу вісь уздовж вала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Cross-coupling Kio, Kip, Kpo</source>
            <translation>Перехресний зв'язок Kio, Kip, Kpo</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the product of the accelerations along two axes shifts the output</source>
            <translation>добуток прискорень уздовж двох осей зміщує вихід</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * (kxy * a_x a_y + kxz * a_x a_z + kyz * a_y a_z)</source>
            <translation>k * (kxy * a_x a_y + kxz * a_x a_z + kyz * a_y a_z)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>second harmonic of the head angle, largest between the quarter turns</source>
            <translation>друга гармоніка кута головки, найбільша між чвертями оберту</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the product term; quarter turns alone never show it</source>
            <translation>калібруйте з членом-добутком; самі лише чверті оберту його ніколи не показують</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Scale-factor asymmetry</source>
            <translation>Асиметрія масштабного коефіцієнта</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the sensitivity to the positive side is another one than to the negative side</source>
            <translation>чутливість у додатний бік інша, ніж у від'ємний</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a V against the input, its kink at zero</source>
            <translation>V-подібна залежність від входу зі зламом у нулі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate the two sides apart; dense points near zero tell it from K2</source>
            <translation>калібруйте обидва боки окремо; густі точки біля нуля відрізняють її від K2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Bias asymmetry K0'</source>
            <translation>Асиметрія зміщення нуля K0'</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the bias on the positive side is another one than on the negative side</source>
            <translation>зміщення нуля з додатного боку інше, ніж з від'ємного</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * K0' * sign(x) / 2</source>
            <translation>k * K0' * sign(x) / 2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a jump where the input changes its sign</source>
            <translation>стрибок там, де вхід змінює знак</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>look for a dead band of the electronics; measure close to zero</source>
            <translation>шукайте зону нечутливості електроніки; вимірюйте поблизу нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Dead band</source>
            <translation>Зона нечутливості</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>small rates are not answered, and all larger ones by so much too little</source>
            <translation>на малі швидкості немає відповіді, а на всі більші вона на стільки ж менша</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>-k * D * sign(w)</source>
            <translation>-k * D * sign(w)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a step at zero rate</source>
            <translation>сходинка за нульової швидкості</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>look for lost motion in the drive of the table; measure small rates</source>
            <translation>шукайте люфт у приводі стенда; виміряйте малі швидкості</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>beyond a level the output grows less than it should</source>
            <translation>понад певний рівень вихід зростає менше, ніж мав би</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>-k * s * (|x| - c) beyond c</source>
            <translation>-k * s * (|x| - c) понад c</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>flat ends of the characteristic</source>
            <translation>плоскі кінці характеристики</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>keep the input below the level; look at the limits of the converter</source>
            <translation>тримайте вхід нижче цього рівня; перевірте межі перетворювача</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Temperature-rate sensitivity</source>
            <translation>Чутливість до швидкості зміни температури</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias follows how fast the temperature changes</source>
            <translation>зміщення нуля залежить від того, як швидко змінюється температура</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bR * dT/dt</source>
            <translation>bR * dT/dt</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>an offset while it warms, the opposite one while it cools</source>
            <translation>зсув під час нагрівання, протилежний під час охолодження</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>change the temperature more slowly, or compensate by dT/dt</source>
            <translation>змінюйте температуру повільніше або компенсуйте за dT/dt</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Thermal lag</source>
            <translation>Теплове запізнення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias follows a part whose temperature lags behind the thermometer's</source>
            <translation>зміщення нуля залежить від частини, температура якої відстає від термометра</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bL * (T lagged by tau)</source>
            <translation>bL * (T із запізненням tau)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>a loop against temperature, wider when it changes faster</source>
            <translation>петля за температурою, ширша за швидшої зміни</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>wait for balance; compensate by the lagged temperature; move the thermometer</source>
            <translation>чекайте рівноваги; компенсуйте за запізнілою температурою; перенесіть термометр</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Thermal hysteresis</source>
            <translation>Тепловий гістерезис</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>warming and cooling leave another bias at the same temperature, however slowly</source>
            <translation>нагрівання й охолодження лишають різне зміщення нуля за тієї самої температури, хоч як повільно</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bH * (T - play(T)) / half width</source>
            <translation>bH * (T - люфт(T)) / півширина</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>two branches against temperature that slow changes do not close</source>
            <translation>дві гілки за температурою, яких не змикають повільні зміни</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>approach temperatures from one side; state the two branches</source>
            <translation>підходьте до температур з одного боку; вкажіть дві гілки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>residuals follow this channel</source>
            <translation>залишки повторюють цей канал</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Quadrature leakage</source>
            <translation>Просочування квадратури</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>a part of the quadrature signal gets into the rate</source>
            <translation>частина квадратурного сигналу потрапляє у швидкість</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bQ * (Q - Q0)</source>
            <translation>bQ * (Q - Q0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>adjust the phase of the demodulator; compensate by the quadrature channel</source>
            <translation>налаштуйте фазу демодулятора; компенсуйте за каналом квадратури</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Demodulation phase error</source>
            <translation>Похибка фази демодуляції</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the phase of the demodulator moves and lets quadrature through</source>
            <translation>фаза демодулятора пливе і пропускає квадратуру</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bF * (phi - phi0) * Q</source>
            <translation>bF * (phi - phi0) * Q</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>stabilise the phase loop; reduce the quadrature; compensate by the product</source>
            <translation>стабілізуйте фазову петлю; зменште квадратуру; компенсуйте за добутком</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Damping anisotropy</source>
            <translation>Анізотропія згасання</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>damping differs by direction, so that the excitation gets into the rate</source>
            <translation>згасання залежить від напряму, тож збудження потрапляє у швидкість</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bE * (E - E0)</source>
            <translation>bE * (E - E0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>compensate by the excitation channel; stabilise the temperature</source>
            <translation>компенсуйте за каналом збудження; стабілізуйте температуру</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Resonator frequency</source>
            <translation>Частота резонатора</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias follows the period of the resonator, a thermometer inside it</source>
            <translation>зміщення нуля залежить від періоду резонатора, термометра в ньому самому</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bP * (P - P0)</source>
            <translation>bP * (P - P0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>compensate by the period instead of the thermometer</source>
            <translation>компенсуйте за періодом замість термометра</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Amplitude error</source>
            <translation>Похибка амплітуди</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the amplitude of the vibration is not held, and the bias follows it</source>
            <translation>амплітуда коливань не утримується, і зміщення нуля йде за нею</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bA * (A - A0)</source>
            <translation>bA * (A - A0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>look at the amplitude control; compensate by the amplitude channel</source>
            <translation>перевірте стабілізацію амплітуди; компенсуйте за каналом амплітуди</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Random telegraph bias</source>
            <translation>Телеграфне зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias jumps to and fro between two levels</source>
            <translation>зміщення нуля стрибає між двома рівнями</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>J * s(t), s = 0 or 1</source>
            <translation>J * s(t), s = 0 або 1</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>two levels against time</source>
            <translation>два рівні за часом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>look for a loose contact, popcorn noise of an amplifier, a latching loop</source>
            <translation>шукайте поганий контакт, вибуховий шум підсилювача, петлю, що замикається</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>belongs to the sensor; state it in the noise model and average accordingly</source>
            <translation>належить датчику; вкажіть його в моделі шуму й усереднюйте відповідно</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Quantisation noise</source>
            <translation>Шум квантування</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the increments of angle are rounded coarsely</source>
            <translation>прирости кута грубо заокруглені</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = (2 pi f)^2 Q^2 dt</source>
            <translation>S(f) = (2 pi f)^2 Q^2 dt</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>slope -1 of the Allan deviation; the spectrum rises with f^2</source>
            <translation>нахил -1 девіації Аллана; спектр зростає як f^2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Angle random walk</source>
            <translation>Випадкове блукання кута</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>white noise of the rate</source>
            <translation>білий шум швидкості</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>slope -1/2 of the Allan deviation; a flat spectrum</source>
            <translation>нахил -1/2 девіації Аллана; плоский спектр</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Bias instability</source>
            <translation>Нестабільність зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>flicker noise: the mean never settles, however long it is taken</source>
            <translation>флікер-шум: середнє ніколи не встановлюється, хоч як довго</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = B^2 / (2 pi f)</source>
            <translation>S(f) = B^2 / (2 pi f)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a floor of the Allan deviation; the spectrum rises with 1/f</source>
            <translation>дно девіації Аллана; спектр зростає як 1/f</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Rate random walk</source>
            <translation>Випадкове блукання швидкості</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the bias walks at random</source>
            <translation>зміщення нуля блукає випадково</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = (K / 2 pi f)^2</source>
            <translation>S(f) = (K / 2 pi f)^2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>slope +1/2 of the Allan deviation; the spectrum rises with 1/f^2</source>
            <translation>нахил +1/2 девіації Аллана; спектр зростає як 1/f^2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Markov noise</source>
            <translation>Марковський шум</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the bias scatters about its mean with a memory of one length</source>
            <translation>зміщення нуля коливається навколо середнього з пам'яттю однієї довжини</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = 2 s^2 tau / (1 + (2 pi f tau)^2)</source>
            <translation>S(f) = 2 s^2 tau / (1 + (2 pi f tau)^2)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a hump of the Allan deviation at 1.89 tau</source>
            <translation>горб девіації Аллана при 1,89 tau</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>samples are missing</source>
            <translation>відліків бракує</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>gaps in the counter or the time</source>
            <translation>пропуски в лічильнику або часі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>steps of time that are whole multiples of the sampling time</source>
            <translation>кроки часу, кратні інтервалу дискретизації</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look at cable, speed of the port and load of the computer; record again</source>
            <translation>перевірте кабель, швидкість порту і навантаження комп'ютера; запишіть знову</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Missing codes</source>
            <translation>Відсутні коди</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the converter never gives some of its codes</source>
            <translation>перетворювач ніколи не дає деяких своїх кодів</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>empty codes between full ones</source>
            <translation>порожні коди між повними</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a comb in the histogram of the codes</source>
            <translation>гребінь у гістограмі кодів</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look at the converter and at the scaling of its codes</source>
            <translation>перевірте перетворювач і масштаб його кодів</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Stale temperature</source>
            <translation>Застигла температура</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the temperature stands still while it cannot</source>
            <translation>температура стоїть, коли не може</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>T bit for bit the same</source>
            <translation>T біт у біт та сама</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a run of equal temperatures far longer than chance</source>
            <translation>ряд однакових температур, значно довший за випадковий</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look at the thermometer; effects of temperature cannot be judged</source>
            <translation>перевірте термометр; ефекти температури оцінити не можна</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Variance burst</source>
            <translation>Сплеск дисперсії</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the scatter was larger for a time</source>
            <translation>розкид якийсь час був більший</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>sigma larger from t1 to t2</source>
            <translation>сигма більша від t1 до t2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a wide stretch of the record</source>
            <translation>широка ділянка запису</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look for vibration, steps, machines at that time; leave the stretch out</source>
            <translation>шукайте вібрацію, кроки, машини в той час; не беріть цю ділянку</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>samples pile up at an extreme value</source>
            <translation>відліки скупчуються на крайньому значенні</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>more samples at the extreme than beside it</source>
            <translation>на крайньому значенні більше відліків, ніж поруч</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a flat top</source>
            <translation>плоский верх</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>choose a larger range; look for shocks</source>
            <translation>виберіть більший діапазон; шукайте удари</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_slow.py" />
            <source>bT * (T - T0) + bT2 * (T - T0)^2 ...</source>
            <translation>bT * (T - T0) + bT2 * (T - T0)^2 ...</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Positions swapped</source>
            <translation>Положення переплутано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>two positions were stored in each other's place</source>
            <translation>два положення збережено одне замість одного</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>rows i and j exchanged</source>
            <translation>рядки i та j переставлено</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>two rows lie off, and exchanging them leaves nothing</source>
            <translation>два рядки випадають, а після їх перестановки не лишається нічого</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>exchange the two rows, or measure them again</source>
            <translation>переставте два рядки або виміряйте їх знову</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Mount reversed</source>
            <translation>Встановлення навпаки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>in one mounting the unit stood the other way round than written</source>
            <translation>в одному встановленні виріб стояв навпаки, ніж записано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>the head turned the other way in that mounting</source>
            <translation>у цьому встановленні головка оберталася в інший бік</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>the cross-axis sensitivity has another sign in one mounting</source>
            <translation>перехресна чутливість має інший знак в одному встановленні</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>correct the mount, or mount it as planned and repeat</source>
            <translation>виправте встановлення або встановіть за планом і повторіть</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Rate sign reversed</source>
            <translation>Знак швидкості навпаки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>the table turned the other way than written</source>
            <translation>стенд обертався в інший бік, ніж записано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>-w in a run or at a row</source>
            <translation>-w у серії або в рядку</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>rows on the line of the opposite slope</source>
            <translation>рядки на прямій з протилежним нахилом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>correct the sign</source>
            <translation>виправте знак</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Channels permuted</source>
            <translation>Канали переставлено</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>outputs of the triad stand in each other's columns</source>
            <translation>виходи тріади стоять не у своїх стовпцях</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>columns of y exchanged</source>
            <translation>стовпці y переставлено</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>a sensor answers to the axis of another one</source>
            <translation>датчик відповідає на вісь іншого</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>correct the names of the columns</source>
            <translation>виправте назви стовпців</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Mounting angle</source>
            <translation>Кут установлення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>in one mounting the unit stands turned on the shaft by a small angle</source>
            <translation>в одному встановленні виріб повернутий на валу на малий кут</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>psi * dU/d(head angle) in that mounting</source>
            <translation>psi * dU/d(кут головки) в цьому встановленні</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the misalignment differs from mounting to mounting</source>
            <translation>неспіввісність різна в різних встановленнях</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>align the unit on the fixture anew; mount it both ways round to tell it from k_zy</source>
            <translation>вирівняйте виріб на оснастці знову; встановіть його обома способами, щоб відрізнити від k_zy</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Shaft tilt</source>
            <translation>Нахил вала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the shaft of the head, or the platform, is not level</source>
            <translation>вал головки або платформа не горизонтальні</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>eps * g * (response along the shaft)</source>
            <translation>eps * g * (чутливість уздовж вала)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>an offset of each mounting, largest in the sensor along the shaft, turning its sign</source>
            <translation>зсув кожного встановлення, найбільший у датчика вздовж вала, що змінює знак</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>level the shaft; mount the unit both ways round</source>
            <translation>вирівняйте вал; встановіть виріб обома способами</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Re-mount bias</source>
            <translation>Зсув від перевстановлення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>bolting on shifted the bias</source>
            <translation>закріплення змінило зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>b in that mounting</source>
            <translation>b у цьому встановленні</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>an offset of one mounting, whichever way round</source>
            <translation>зсув одного встановлення, хоч яким боком</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>return to the first mounting at the end; torque the screws alike</source>
            <translation>наприкінці поверніться до першого встановлення; затягуйте гвинти однаково</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>certify the head; re-index the unit by 90 degrees on the dial and repeat</source>
            <translation>атестуйте головку; переставте виріб на 90 градусів на шкалі й повторіть</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Head eccentricity</source>
            <translation>Ексцентриситет головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the dial sits off centre, so the angle is wrong once a turn</source>
            <translation>шкала сидить не по центру, тож кут хибний раз на оберт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>dU/d(head angle) * e * sin(head angle - phase)</source>
            <translation>dU/d(кут головки) * e * sin(кут головки - фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>second harmonic of the head angle and a constant</source>
            <translation>друга гармоніка кута головки і стала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Head ellipticity</source>
            <translation>Еліптичність головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the dial is out of round, so the angle is wrong twice a turn</source>
            <translation>шкала не кругла, тож кут хибний двічі на оберт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>dU/d(head angle) * e * sin(2 head angle - phase)</source>
            <translation>dU/d(кут головки) * e * sin(2 кути головки - фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>first and third harmonic of the head angle</source>
            <translation>перша і третя гармоніки кута головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Head periodic error</source>
            <translation>Періодична похибка головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>worm or division make the angle wrong many times a turn</source>
            <translation>черв'як або поділки роблять кут хибним багато разів на оберт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>dU/d(head angle) * e * sin(N head angle + phase)</source>
            <translation>dU/d(кут головки) * e * sin(N кут головки + фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>a fast harmonic of the head angle that repeats in every run</source>
            <translation>швидка гармоніка кута головки, що повторюється в кожній серії</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Table slip</source>
            <translation>Проковзування стенда</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>above a rate the drive of the table slips</source>
            <translation>понад певну швидкість привід стенда проковзує</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>-k * s * (|w| - w_s) * sign(w) above w_s</source>
            <translation>-k * s * (|w| - w_s) * sign(w) понад w_s</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>both ends of the characteristic turn towards zero</source>
            <translation>обидва кінці характеристики загинаються до нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>measure the period of the table; tighten the belt</source>
            <translation>виміряйте період стенда; натягніть пас</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Wrong speed at one setting</source>
            <translation>Неправильна швидкість за однієї уставки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>at one setting the table runs at another speed than it says</source>
            <translation>за однієї уставки стенд обертається з іншою швидкістю, ніж показує</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>k * e at that setting</source>
            <translation>k * e за цієї уставки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>all rows of one set rate lie off</source>
            <translation>усі рядки однієї заданої швидкості випадають</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>measure the period of the table at this setting</source>
            <translation>виміряйте період стенда за цієї уставки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Wobble of the table</source>
            <translation>Биття стенда</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>the axis of the table is tilted; what swings round does not average out</source>
            <translation>вісь стенда нахилена; те, що обертається навколо, не усереднюється</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>b * mean of sin and cos(w t) over the accumulation</source>
            <translation>b * середнє sin і cos(w t) за накопичення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>residuals at small rates that depend on the length of the accumulation</source>
            <translation>залишки за малих швидкостей, що залежать від тривалості накопичення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>accumulate over whole turns; level the table</source>
            <translation>накопичуйте за цілі оберти; вирівняйте стенд</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Scale factor with amplitude</source>
            <translation>Масштабний коефіцієнт від амплітуди</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>the sensitivity of the vibratory gyro follows its drive amplitude</source>
            <translation>чутливість вібраційного гіроскопа залежить від амплітуди коливань</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>slope of the characteristic changes with the amplitude</source>
            <translation>нахил характеристики змінюється з амплітудою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>look at the amplitude control; calibrate with the amplitude</source>
            <translation>перевірте стабілізацію амплітуди; калібруйте з амплітудою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Bias drift</source>
            <translation>Дрейф зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias goes steadily with time</source>
            <translation>зміщення нуля рівномірно змінюється з часом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a straight line against time</source>
            <translation>пряма лінія за часом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>wait until it has settled; repeat the first positions at the end</source>
            <translation>зачекайте, доки встановиться; повторіть перші положення наприкінці</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Bias temperature sensitivity</source>
            <translation>Температурна чутливість зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias follows the temperature</source>
            <translation>зміщення нуля змінюється за температурою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>bT * (T - T0)</source>
            <translation>bT * (T - T0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a straight line against temperature</source>
            <translation>пряма лінія за температурою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>calibrate over temperature; change the temperature on purpose by 10 degrees</source>
            <translation>калібруйте за температурою; навмисно змініть температуру на 10 градусів</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Scale-factor temperature sensitivity</source>
            <translation>Температурна чутливість масштабного коефіцієнта</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the sensitivity follows the temperature</source>
            <translation>чутливість змінюється за температурою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>k * kT * (T - T0) * x</source>
            <translation>k * kT * (T - T0) * x</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>slope of the characteristic changes with temperature</source>
            <translation>нахил характеристики змінюється з температурою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>calibrate over temperature; state T0 with the scale factor</source>
            <translation>калібруйте за температурою; вказуйте T0 разом із масштабним коефіцієнтом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>after switching on the bias settles exponentially</source>
            <translation>після увімкнення зміщення нуля встановлюється за експонентою</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>W * exp(-t / tau)</source>
            <translation>W * exp(-t / tau)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the first rows lie off and come closer</source>
            <translation>перші рядки випадають і наближаються</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>switch on earlier; begin when the temperature stands</source>
            <translation>вмикайте раніше; починайте, коли температура встановилася</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Bias jump</source>
            <translation>Стрибок зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias jumped once and stayed</source>
            <translation>зміщення нуля стрибнуло один раз і лишилося</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>J from one row on</source>
            <translation>J від одного рядка далі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a step against time</source>
            <translation>сходинка за часом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>repeat the test; look for a knock, a re-start, a change of the supply</source>
            <translation>повторіть випробування; шукайте удар, перезапуск, зміну живлення</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Run-to-run bias</source>
            <translation>Зміщення нуля від серії до серії</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias is another one in one run</source>
            <translation>в одній серії зміщення нуля інше</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>b in that run</source>
            <translation>b у цій серії</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>one run lies off</source>
            <translation>одна серія випадає</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>leave the unit powered between runs; state the turn-on repeatability</source>
            <translation>не вимикайте виріб між серіями; вкажіть повторюваність увімкнень</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Run-to-run scale factor</source>
            <translation>Масштабний коефіцієнт від серії до серії</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the sensitivity is another one in one run</source>
            <translation>в одній серії чутливість інша</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>k * s * x in that run</source>
            <translation>k * s * x у цій серії</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>one run has another slope</source>
            <translation>одна серія має інший нахил</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>leave the unit powered between runs; check the speed of the table</source>
            <translation>не вимикайте виріб між серіями; перевірте швидкість стенда</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Periodic pick-up</source>
            <translation>Періодична завада</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>something periodic in time is picked up</source>
            <translation>наводиться щось періодичне в часі</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>A * sin(2 pi f t + phase)</source>
            <translation>A * sin(2 pi f t + фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a sine against time</source>
            <translation>синусоїда за часом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>look for mains and motors; reverse a run, which tells it from an error of the head</source>
            <translation>шукайте мережу живлення й двигуни; переверніть серію: це відрізняє заваду від похибки головки</translation>
        </message>
        <message>
            <location filename="../../core/model/effect.py" />
            <source>{id} has {len} shape values, not {len2}</source>
            <translation>{id} має {len} [значення|значення|значень] форми, а не {len2}</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>local gravity must be a positive number in m/s^2, got {x}</source>
            <translation>місцеве прискорення тяжіння має бути додатним числом у m/s^2, отримано {x}</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>row {missing}: the set rate is missing</source>
            <translation>рядок {missing}: немає заданої швидкості</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>the sensors look along {join}, and the run does not say which of these axes stood along the table's; give a mount, e.g. Z_from for Z up</source>
            <translation>датчики дивляться вздовж {join}, а серія не каже, яка з цих осей стояла вздовж осі стенда; вкажіть встановлення, напр. Z_from для Z вгору</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>the data hold no complete column {name}, which the model needs</source>
            <translation>дані не мають повного стовпця {name}, потрібного моделі</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>row {row}: the head angle is missing</source>
            <translation>рядок {row}: немає кута головки</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>row {row}: {error}</source>
            <translation>рядок {row}: {error}</translation>
        </message>
        <message>
            <location filename="../../core/plans/orientation.py" />
            <source>unknown mount {text}; expected X_from, X_to, Y_from, Y_to, Z_from or Z_to, optionally with a re-index angle such as X_from@90</source>
            <translation>невідоме встановлення {text}; очікується X_from, X_to, Y_from, Y_to, Z_from або Z_to, за потреби з кутом повороту, напр. X_from@90</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>the file</source>
            <translation>файл</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[plan] test = {test}; expected one of {join}</source>
            <translation>[plan] test = {test}; очікується одне з {join}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>a plan needs at least one [[group]]</source>
            <translation>план потребує щонайменше однієї [[group]]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>step numbers used twice: {sorted}</source>
            <translation>номери кроків ужито двічі: {sorted}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[[group]] {title}: give either head_deg or rates_dps, a list of numbers</source>
            <translation>[[group]] {title}: дайте або head_deg, або rates_dps, список чисел</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[[group]] {title}: {len} numbers for {count} steps</source>
            <translation>[[group]] {title}: {len} [номер|номери|номерів] на {count} [крок|кроки|кроків]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>not TOML: {error}</source>
            <translation>не TOML: {error}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>a group is {group}; write it as a table [[group]]</source>
            <translation>група — {group}; пишіть її таблицею [[group]]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[[group]] {title}: {error}</source>
            <translation>[[group]] {title}: {error}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{where} needs a table [{key}]</source>
            <translation>{where} потребує таблиці [{key}]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{key} is missing or no text</source>
            <translation>{key} відсутній або не текст</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{key} must be a list of numbers</source>
            <translation>{key} має бути списком чисел</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{key} holds {item}, which is no number</source>
            <translation>{key} містить {item}, що не є числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy.py" />
            <source>the run holds no rows</source>
            <translation>серія не містить рядків</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy.py" />
            <source>{device}: there are neither angles of the unit nor raw codes with a calibration</source>
            <translation>{device}: немає ні кутів виробу, ні необроблених кодів із калібруванням</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the angles are {error} deg off the set ones: another list of angles, pitch taken for roll, or another mount?</source>
            <translation>кути відрізняються на {error} deg від заданих: інший список кутів, тангаж замість крену чи інше встановлення?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>{device} sends angles but no raw codes of its accelerometers: only its own angles are judged, none by a calibration</source>
            <translation>{device} передає кути, але не коди акселерометрів: оцінюються лише його власні кути, без калібрування</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>no calibration was chosen: only the unit's own angles are judged; calibrate it on the head to judge the raw codes</source>
            <translation>калібрування не вибрано: оцінюються лише власні кути виробу; відкалібруйте його на головці, щоб оцінити коди</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the uncertainty of a head setting was not stated: the verdict counts noise and resolution only</source>
            <translation>невизначеність установлення головки не вказано: рішення враховує лише шум і роздільність</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the angles follow the set ones with the opposite sign ({error} deg off as they are, {back} deg with the sign turned): the unit is mounted the other way round, or the head was turned the other way</source>
            <translation>кути повторюють задані з протилежним знаком (різниця {error} deg як є, {back} deg зі зміненим знаком): виріб встановлено навпаки або головку обертали в інший бік</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the calibration is of {name}, the angles were measured on {device}</source>
            <translation>калібрування належить {name}, а кути виміряно на {device}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>row {place}: the specific force is {in_mg} mg from g (u = {milli} mg): the sensors are no longer what they were when calibrated; another temperature or another day?</source>
            <translation>рядок {place}: уявне прискорення відрізняється від g на {in_mg} mg (u = {milli} mg): датчики вже не такі, як під час калібрування; інша температура чи інший день?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the errors by the calibration are {times} times larger than its uncertainty and that of the head allow (p = {p_value}): the unit has changed, or it sits askew on the head (see the aligned errors)</source>
            <translation>похибки за калібруванням у {times} [раз|раза|разів] більші, ніж допускають його невизначеність і невизначеність головки (p = {p_value}): виріб змінився або стоїть на головці навскіс (див. вирівняні похибки)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>{title}: pitch is set with X along the shaft, roll with Y</source>
            <translation>{title}: тангаж задають з X уздовж вала, крен — з Y</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>a list of angles holds 1 to {most} of them, not {len}</source>
            <translation>список кутів містить від 1 до {most}, а не {len}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>the list is empty; write e.g. 0, 30, 60</source>
            <translation>список порожній; пишіть, напр., 0, 30, 60</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>{word} is no angle from -360 to 360 deg</source>
            <translation>{word} не є кутом від -360 до 360 deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>{word} is no angle; write e.g. 0, 30, 60</source>
            <translation>{word} не є кутом; пишіть, напр., 0, 30, 60</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_sources.py" />
            <source>angles need a calibration of the accelerometers, this one is of gyros</source>
            <translation>кути потребують калібрування акселерометрів, а це — гіроскопів</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_sources.py" />
            <source>the calibration takes {unit}, the codes are in {unit2}</source>
            <translation>калібрування приймає {unit}, а коди в {unit2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/added.py" />
            <source>of the sensor</source>
            <translation>датчика</translation>
        </message>
        <message>
            <location filename="../../core/procedures/added.py" />
            <source>of this test alone</source>
            <translation>лише цього випробування</translation>
        </message>
        <message>
            <location filename="../../core/procedures/added.py" />
            <source>effects are added to plain models alone, not to {join}</source>
            <translation>ефекти додаються лише до простих моделей, а не до {join}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/calibration.py" />
            <source>Q needs three sensors with bias, scale factor and both cross axes each</source>
            <translation>Q потребує трьох датчиків, кожен зі зміщенням нуля, масштабним коефіцієнтом і обома перехресними</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>Scale factor asymmetry</source>
            <translation>Асиметрія масштабного коефіцієнта</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>Acceleration-sensitive drift, largest axis</source>
            <translation>Дрейф від прискорення, найбільша вісь</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>{value} (no uncertainty)</source>
            <translation>{value} (без невизначеності)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>no gyro was chosen for the comparison</source>
            <translation>для порівняння не вибрано жодного гіроскопа</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>two gyros have the same name ({join}); tell them apart</source>
            <translation>два гіроскопи мають однакову назву ({join}); розрізніть їх</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>{unit} and {unit2} cannot be compared</source>
            <translation>{unit} і {unit2} неможливо порівняти</translation>
        </message>
        <message>
            <location filename="../../core/procedures/compensation.py" />
            <source>the effects of this calibration are as large as its scale factor at these outputs; they cannot be taken out</source>
            <translation>ефекти цього калібрування за таких виходів такі ж великі, як його масштабний коефіцієнт; вилучити їх неможливо</translation>
        </message>
        <message>
            <location filename="../../core/procedures/compensation.py" />
            <source>this calibration has effects of temperature: state the temperature</source>
            <translation>це калібрування має температурні ефекти: вкажіть температуру</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>a limit must be above zero, got {limit}</source>
            <translation>межа має бути більша за нуль, отримано {limit}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>nothing was judged</source>
            <translation>нічого не оцінено</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>pass: the value and its expanded uncertainty (95 %) lie within the limit; fail: both lie beyond it; otherwise undecided (JCGM 106, guard band w = U)</source>
            <translation>відповідає: значення та його розширена невизначеність (95 %) лежать у межі; не відповідає: обидва за нею; інакше не вирішено (JCGM 106, захисна смуга w = U)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>pass: the value lies within the limit, whatever its uncertainty; else fail (ILAC-G8, simple acceptance; the risk of a wrong verdict at the limit is up to 50 %)</source>
            <translation>відповідає: значення лежить у межі, хоч яка його невизначеність; інакше не відповідає (ILAC-G8, просте прийняття; ризик хибного рішення на межі до 50 %)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>accelerometers on the dividing head, practicum (1.8), (2.4)</source>
            <translation>акселерометри на ділильній головці, практикум (1.8), (2.4)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>local gravity is missing; state it in m/s^2, e.g. 9.8106 for Kyiv</source>
            <translation>місцеве g відсутнє; вкажіть його в m/s^2, напр. 9,8106 для Києва</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>rows {rows} give a bias of {bias} {unit}, rows {rows2} one of {bias2}: {difference} {unit2} = {difference2} mg apart. A second-order nonlinearity, a drift or a wrong position would do this; measure more positions to tell which</source>
            <translation>рядки {rows} дають зміщення нуля {bias} {unit}, рядки {rows2} — {bias2}: різниця {difference} {unit2} = {difference2} mg. Так діяла б нелінійність другого порядку, дрейф або неправильне положення; виміряйте більше положень, щоб дізнатися</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>{join}: the scale factor is negative, which is legal; the output falls when its axis points up. If every earlier calibration had it positive, the unit was mounted upside down</source>
            <translation>{join}: масштабний коефіцієнт від'ємний, що припустимо; вихід спадає, коли вісь дивиться вгору. Якщо всі попередні калібрування мали його додатним, виріб було встановлено догори дном</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>{join} left out: these positions do not determine them; add a rotation about another axis</source>
            <translation>{join} пропущено: ці положення їх не визначають; додайте обертання навколо іншої осі</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>{name} follows another axis more than its own ({axis}): are the channels permuted, or is the unit mounted about another axis than the plan says?</source>
            <translation>{name} реагує на іншу вісь сильніше, ніж на свою ({axis}): переставлено канали чи виріб встановлено навколо іншої осі, ніж каже план?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/angles.py" />
            <source>segments {which}: the temperature changes by less than {telling} times its uncertainty; the coefficient against temperature (1) is not defined there</source>
            <translation>ділянки {which}: температура змінюється менш ніж на {telling} своїх невизначеностей; коефіцієнт за температурою (1) там не визначений</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>the knots were moved by hand: the score of this table takes them as given, that of the optimal table also holds what searching them without the held-out turn-on costs</source>
            <translation>вузли переміщено вручну: оцінка цієї таблиці бере їх як задані, а оцінка оптимальної містить і ціну пошуку їх без вилученого увімкнення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>{limit} knots for {blocks} blocks; state between 2 and {blocks2}</source>
            <translation>{limit} [вузол|вузли|вузлів] на {blocks} [блок|блоки|блоків]; вкажіть від 2 до {blocks2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>{knots} knots; the memory limit allows 2 to {limit}</source>
            <translation>{knots} [вузол|вузли|вузлів]; обмеження пам'яті допускає від 2 до {limit}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>knots must be two or more times in ascending order</source>
            <translation>вузлів має бути два або більше, за зростанням часу</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>knots nearer to each other than a block of {block} s mean nothing</source>
            <translation>вузли ближче один до одного, ніж блок {block} s, нічого не означають</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>in the sets at {join} degC there are segments in which the chip's temperature stands still: the source's coefficients against temperature (1) divide by zero there; this table runs over time and needs none</source>
            <translation>у наборах при {join} °C є ділянки, де температура кристала стоїть на місці: коефіцієнти джерела за температурою (1) там ділять на нуль; ця таблиця йде за часом і їх не потребує</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>each temperature has one turn-on: nothing tells drift from what differs between turn-ons, and the number of knots is not tested; make about five</source>
            <translation>кожна температура має одне увімкнення: ніщо не відрізняє дрейф від різниць між увімкненнями, і кількість вузлів не перевірено; зробіть близько п'яти</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>the start is aligned by a mean over {window} s, whose noise of {x} {unit} is a large part of the {by_name} {unit2} that the table leaves; a longer window would help more than more knots</source>
            <translation>початок вирівняно за середнім за {window} s, шум якого {x} {unit} є великою частиною {by_name} {unit2}, що їх залишає таблиця; довше вікно допоможе більше, ніж більше вузлів</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>on turn-ons that it has not seen the table leaves {by_name} {unit}, no correction {by_name2}: the drift does not repeat, do not use it</source>
            <translation>на увімкненнях, яких вона не бачила, таблиця залишає {by_name} {unit}, без корекції — {by_name2}: дрейф не повторюється, не використовуйте її</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>the start window {start} ... {stop} s holds no samples: the records begin at {latest} s</source>
            <translation>початкове вікно {start} ... {stop} s не містить відліків: записи починаються з {latest} s</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>{max} blocks of {block_s} s between {stop} s and {horizon_s} s; at least {fewest_blocks} are needed, with one sample each</source>
            <translation>{max} [блок|блоки|блоків] по {block_s} s між {stop} s і {horizon_s} s; потрібно щонайменше {fewest_blocks}, з одним відліком у кожному</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>the chip's temperature was not measured; the table is entered by the temperature of the chamber, which the unit does not know in use</source>
            <translation>температуру кристала не виміряно; вхід таблиці — температура камери, якої виріб під час роботи не знає</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>the chip's temperature at the start does not rise with that of the chamber: {join} degC; are sets mislabelled?</source>
            <translation>температура кристала на початку не зростає з температурою камери: {join} °C; чи не переплутано набори?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>all turn-ons were made at {chip} degC: the table holds at this temperature only</source>
            <translation>усі увімкнення зроблено при {chip} °C: таблиця дійсна лише за цієї температури</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>{label} began at {start} degC, the others of its set at {middle} degC: it had not cooled down and was left out; wait longer between turn-ons (source 003 advises at least 5 minutes)</source>
            <translation>{label} почалося з {start} °C, інші цього набору — з {middle} °C: виріб не охолов, увімкнення пропущено; чекайте довше між увімкненнями (джерело 003 радить щонайменше 5 хвилин)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/held_out.py" />
            <source>without repeated turn-ons none can be left out</source>
            <translation>без повторних увімкнень жодне не можна вилучити</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/simulated.py" />
            <source>simulated, {ambient} degC, turn-on {number}</source>
            <translation>симуляція, {ambient} °C, увімкнення {number}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/table.py" />
            <source>{temperature_c} degC is outside the measured {low} ... {high} degC; the drift there is not known</source>
            <translation>{temperature_c} °C поза виміряним {low} ... {high} °C; дрейф там невідомий</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/table.py" />
            <source>times {min} ... {max} s leave the measured {start} ... {stop} s; the drift there is not known</source>
            <translation>часи {min} ... {max} s виходять за виміряні {start} ... {stop} s; дрейф там невідомий</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{device}, turn-on {number}</source>
            <translation>{device}, увімкнення {number}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>there is no turn-on</source>
            <translation>немає жодного увімкнення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>there are sets at {low} and at {high} degC; give turn-ons of one set the same temperature</source>
            <translation>є набори при {low} і при {high} °C; дайте увімкненням одного набору однакову температуру</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: the time since switching on is missing</source>
            <translation>{label}: немає часу від увімкнення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: rows {place} and {place2} are {steps} s apart, the others {step} s; gaps cannot be averaged over</source>
            <translation>{label}: рядки {place} і {place2} віддалені на {steps} s, інші на {step} s; через пропуски не можна усереднювати</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: sample {bad} is not a number</source>
            <translation>{label}: відлік {bad} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: the temperature of the chamber is missing</source>
            <translation>{label}: немає температури камери</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label} has {rate} samples per second, {label2} {rate2}; turn-ons of one table need the same</source>
            <translation>{label} має {rate} [відлік|відліки|відліків] за секунду, {label2} — {rate2}; увімкнення однієї таблиці потребують однакової частоти</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: {len} temperatures, {len2} rows</source>
            <translation>{label}: {len} [температура|температури|температур], {len2} [рядок|рядки|рядків]</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>the turn-ons differ in length: {label} ends at {min} s, {label2} at {max} s; state a horizon of at most {min2} s to use the common part</source>
            <translation>увімкнення різної довжини: {label} закінчується на {min} s, {label2} — на {max} s; вкажіть горизонт не більше {min2} s, щоб узяти спільну частину</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label} ends at {min} s, before the horizon of {horizon_s} s</source>
            <translation>{label} закінчується на {min} s, раніше за горизонт {horizon_s} s</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: the temperatures of chamber and chip are both unknown</source>
            <translation>{label}: температури камери і кристала обидві невідомі</translation>
        </message>
        <message>
            <location filename="../../core/procedures/earth.py" />
            <source>this gyro feels the rotation of the Earth, and no latitude was stated: up to {earth_rate_dps} deg/h times the sine of the latitude went into {goes_into}; {remedy}</source>
            <translation>цей гіроскоп відчуває обертання Землі, а широту не вказано: до {earth_rate_dps} deg/h, помножені на синус широти, увійшли до {goes_into}; {remedy}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/earth.py" />
            <source>this gyro feels the rotation of the Earth, and the azimuth of the head was not stated: up to {level} deg/h went into {goes_into}; state the azimuth of the shaft</source>
            <translation>цей гіроскоп відчуває обертання Землі, а азимут головки не вказано: до {level} deg/h увійшли до {goes_into}; вкажіть азимут вала</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/faults.py" />
            <source>all angles are multiples of 90 degrees, where the second harmonic is invisible; measure between them, e.g. every 45 or every 5 degrees</source>
            <translation>усі кути кратні 90 градусам, де друга гармоніка невидима; вимірюйте між ними, напр. через 45 або через 5 градусів</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/faults.py" />
            <source>{len} different angles for {needed} coefficients; measure at least {needed2}, better every 5 degrees</source>
            <translation>{len} різних кутів на {needed} коефіцієнтів; виміряйте щонайменше {needed2}, краще через 5 градусів</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/faults.py" />
            <source>the output is {extreme}, its {word}, over {span} degrees: it is saturated; choose a wider range of the sensor</source>
            <translation>вихід дорівнює {extreme}, своєму {word}, протягом {span} градусів: він насичений; виберіть ширший діапазон датчика</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/flip.py" />
            <source>the tumbles are of {axis} in the {axis2}-{cross} plane and of {axis3} in the {axis4}-{cross2} plane; one sensor is needed</source>
            <translation>оберти є для {axis} в площині {axis2}-{cross} і для {axis3} в площині {axis4}-{cross2}; потрібен один датчик</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/flip.py" />
            <source>the sensor was not turned over between the tumbles: in both the input axis moves in the same sense with the head; turn it by 180 degrees about its input axis</source>
            <translation>датчик не перевернуто між обертами: в обох вхідна вісь рухається в тому самому напрямі з головкою; поверніть його на 180 градусів навколо вхідної осі</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/flip.py" />
            <source>a tumble has no uncertainty; repeat angles</source>
            <translation>оберт не має невизначеності; повторіть кути</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/pairs.py" />
            <source>no axis stood up and down; a test turn needs both positions</source>
            <translation>жодна вісь не стояла вгору і вниз; випробувальний оберт потребує обох положень</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/readings.py" />
            <source>{shape} angles for {shape2} readings; one angle a row is needed</source>
            <translation>{shape} [кут|кути|кутів] на {shape2} [показ|покази|показів]; потрібен один кут на рядок</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>Harmonics of the tumble</source>
            <translation>Гармоніки оберту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>how the output changes over a turn of the head</source>
            <translation>як змінюється вихід за оберт головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>C0 + C1 sin a + C2 cos a + C3 sin 2a + C4 cos 2a</source>
            <translation>C0 + C1 sin a + C2 cos a + C3 sin 2a + C4 cos 2a</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>the output changes steadily while the head is turned</source>
            <translation>вихід рівномірно змінюється, поки головку обертають</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>D * (order - middle) / (last - first)</source>
            <translation>D * (порядок - середина) / (останній - перший)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/split.py" />
            <source>the split (18) assumes that the sensor has no quadratic term K2: one of half the size of k_xy would move alpha0 by 13 degrees; turn the sensor over in its fixture and tumble it again to do without the assumption</source>
            <translation>розклад (18) припускає, що датчик не має квадратичного члена K2: такий член у половину k_xy зсунув би alpha0 на 13 градусів; переверніть датчик в оснастці й виміряйте оберт знову, щоб обійтися без припущення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/split.py" />
            <source>the fit has no uncertainty: repeat angles before splitting (18)</source>
            <translation>оцінка не має невизначеності: повторіть кути перед розкладом (18)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/split.py" />
            <source>the second harmonic is {ratio} times its uncertainty, {separable} are needed: mounting angle and cross-axis sensitivity cannot be told apart; their sum is {value} +- {expanded} deg</source>
            <translation>друга гармоніка в {ratio} [раз|раза|разів] більша за свою невизначеність, потрібно {separable}: кут установлення і перехресну чутливість не розрізнити; їх сума {value} +- {expanded} deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>{harmonics} harmonics; the series has 2 or 3</source>
            <translation>{harmonics} [гармоніка|гармоніки|гармонік]; ряд має 2 або 3</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the run holds the mounts {join}; a tumble is the turn of one mount, choose its rows</source>
            <translation>серія містить встановлення {join}; оберт — це поворот в одному встановленні, виберіть його рядки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the angles determine the series badly (condition {condition}); spread them over the whole turn</source>
            <translation>кути погано визначають ряд (обумовленість {condition}); розподіліть їх по всьому оберту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>row {missing}: the head angle is missing</source>
            <translation>рядок {missing}: немає кута головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>{channels}: state the case axis along which it looks</source>
            <translation>{channels}: вкажіть вісь корпусу, вздовж якої він дивиться</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the {axis} axis lies along the shaft of the head ({mount}): turning it changes nothing; mount the unit with another axis along the shaft</source>
            <translation>вісь {axis} лежить уздовж вала головки ({mount}): її обертання нічого не змінює; встановіть виріб іншою віссю вздовж вала</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the output changes by {length} {unit} over a turn, which is not more than noise ({x}): it does not follow the head; is the sensor alive, is this its channel?</source>
            <translation>вихід змінюється на {length} {unit} за оберт, що не більше за шум ({x}): він не йде за головкою; чи живий датчик, чи це його канал?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the angles leave {gap} degrees of the turn out; an error of the model shows in all coefficients then</source>
            <translation>кути пропускають {gap} [градус|градуси|градусів] оберту; похибка моделі тоді видна в усіх коефіцієнтах</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>after a full turn the output came back changed by {value} +- {student_t} {unit}: it drifts, with temperature or since switching on; fit the drift along, or wait and repeat</source>
            <translation>після повного оберту вихід повернувся зміненим на {value} +- {student_t} {unit}: він дрейфує з температурою або від увімкнення; оцініть дрейф разом або зачекайте й повторіть</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>g-sensitivity on the dividing head, practicum (3.7) to (3.9)</source>
            <translation>g-чутливість на ділильній головці, практикум (3.7)–(3.9)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>gravity acts alike in every row: no g-sensitivity can be told from it; measure positions that turn the unit over</source>
            <translation>сила тяжіння діє однаково в кожному рядку: g-чутливості з цього не видно; виміряйте положення, що перевертають виріб</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>the g-sensitivity of {channel}</source>
            <translation>g-чутливість {channel}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>{channel}: no scale factor is known, so that codes cannot become deg/s; measure it on the rate table</source>
            <translation>{channel}: масштабний коефіцієнт невідомий, тож коди не стануть deg/s; виміряйте його на поворотному стенді</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>{symbol} of {channel}</source>
            <translation>{symbol} каналу {channel}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>state the latitude</source>
            <translation>вкажіть широту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>Earth rate on a turning axis, and drift</source>
            <translation>Обертання Землі на повертаній осі і дрейф</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the axis feels the Earth by its azimuth, and drifts</source>
            <translation>вісь відчуває Землю за своїм азимутом і дрейфує</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>A cos(delta) - B sin(delta) + d</source>
            <translation>A cos(delta) - B sin(delta) + d</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>Drift ramp</source>
            <translation>Лінійна зміна дрейфу</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the drift changes steadily, e.g. while the unit warms up</source>
            <translation>дрейф рівномірно змінюється, напр. поки виріб прогрівається</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>r * (t - middle)</source>
            <translation>r * (t - середина)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the tilt brings in the vertical part of the Earth's rate: state the latitude</source>
            <translation>нахил вносить вертикальну складову обертання Землі: вкажіть широту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>a latitude of {latitude_deg} deg does not exist; -90 to 90, south negative</source>
            <translation>широти {latitude_deg} deg не існує; від -90 до 90, південна від'ємна</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>at {latitude_deg} deg of latitude the Earth's rate has no level part to speak of ({dph_per_dps} deg/h): at a pole a gyro finds no heading</source>
            <translation>на широті {latitude_deg} deg горизонтальної складової обертання Землі майже немає ({dph_per_dps} deg/h): на полюсі гіроскоп не знаходить курсу</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the output is in {unit}, which is no rate; state the scale factor in {unit2}/(deg/s)</source>
            <translation>вихід у {unit}, що не є кутовою швидкістю; вкажіть масштабний коефіцієнт у {unit2}/(deg/s)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>as many headings as unknowns leave no uncertainty; add a heading, or standard errors</source>
            <translation>курсів стільки, скільки невідомих, тож немає невизначеності; додайте курс або стандартні похибки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>; the Earth's is {earth} there</source>
            <translation>; земна там {earth}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the rate changes by {length} deg/h with the heading, u = {x} deg/h{there}: north cannot be told from noise; average longer, or use a quieter gyro</source>
            <translation>швидкість змінюється на {length} deg/h з курсом, u = {x} deg/h{there}: північ не відрізнити від шуму; усереднюйте довше або візьміть тихіший гіроскоп</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>{leak} arcmin</source>
            <translation>{leak} кут. хв</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>tan(latitude) arcmin</source>
            <translation>tan(широти) кут. хв</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>these headings do not tell the Earth's rate from drift; turn the base in steps of 90 degrees (at least three different headings, not all on one line)</source>
            <translation>ці курси не відрізняють обертання Землі від дрейфу; повертайте основу кроками по 90 градусів (щонайменше три різні курси, не на одній прямій)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>no latitude was stated: the {value} deg/h that were found could not be compared with the Earth's rate</source>
            <translation>широту не вказано: знайдені {value} deg/h не порівняно з обертанням Землі</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the tilt was not measured: each arcmin by which the base leans east or west moves the heading by {much}</source>
            <translation>нахил не виміряно: кожна кутова хвилина нахилу основи на схід або захід зсуває курс на {much}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the level part of the Earth's rate came out as {value} +- {expanded} deg/h, at {latitude_deg} deg it is {expected_dph}: check scale factor and latitude; the heading does not depend on them</source>
            <translation>горизонтальна складова обертання Землі вийшла {value} +- {expanded} deg/h, на широті {latitude_deg} deg вона {expected_dph}: перевірте масштабний коефіцієнт і широту; курс від них не залежить</translation>
        </message>
        <message>
            <location filename="../../core/procedures/measuring.py" />
            <source>the head moved during accumulation ({names} changed); wait and accumulate again</source>
            <translation>головка рухалася під час накопичення (змінилися {names}); зачекайте й накопичте знову</translation>
        </message>
        <message>
            <location filename="../../core/procedures/north_seeking.py" />
            <source>these headings do not tell the Earth's rate from drift; use steps of 90 deg</source>
            <translation>ці курси не відрізняють обертання Землі від дрейфу; повертайте кроками по 90 deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/north_seeking.py" />
            <source>at {latitude_deg} deg of latitude a gyro finds no heading</source>
            <translation>на широті {latitude_deg} deg гіроскоп не знаходить курсу</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a tumble is the turn of one mount</source>
            <translation>оберт — це поворот в одному встановленні</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>the {axis} axis lies along the shaft</source>
            <translation>вісь {axis} лежить уздовж вала</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a gyrocompass needs the latitude, and a place that is no pole</source>
            <translation>гірокомпас потребує широти і місця, що не є полюсом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Positions on the dividing head</source>
            <translation>Положення на ділильній головці</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>bias, scale factor and cross-axis sensitivity of one to nine accelerometers; of a triad the matrix Q, non-orthogonality and mounting</source>
            <translation>зміщення нуля, масштабний коефіцієнт і перехресна чутливість від одного до дев'яти акселерометрів; для тріади — матриця Q, неортогональність і встановлення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; four positions about one axis for a part, six or eight for all of them</source>
            <translation>g; чотири положення навколо однієї осі для частини, шість або вісім для всіх</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Fourier tumble</source>
            <translation>Оберт за Фур'є</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>bias, sensitivity and misalignment of one accelerometer in the plane of rotation, and its second and third harmonic (nonlinearity)</source>
            <translation>зміщення нуля, чутливість і неспіввісність одного акселерометра в площині обертання, його друга і третя гармоніки (нелінійність)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; at least 5 different angles that are not all multiples of 90 degrees, better 80; a second run with the sensor turned over to tell the fixture from the sensor</source>
            <translation>g; щонайменше 5 різних кутів, не всі кратні 90 градусам, краще 80; друга серія з перевернутим датчиком, щоб відрізнити оснастку від датчика</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Positions over temperature</source>
            <translation>Положення за температурою</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>bias and scale factor against temperature, told apart, and their hysteresis</source>
            <translation>зміщення нуля і масштабний коефіцієнт за температурою, розрізнені, та їх гістерезис</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; each axis up and down at two temperatures or more, S + 2 for order S; both ways through the temperatures to see hysteresis</source>
            <translation>g; кожна вісь вгору і вниз за двох температур або більше, S + 2 для порядку S; обома напрямами через температури, щоб побачити гістерезис</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Rates on the table</source>
            <translation>Швидкості на стенді</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>scale factor and zero of gyros, nonlinearity, asymmetry; cross axes by re-mounting</source>
            <translation>масштабний коефіцієнт і нульовий сигнал гіроскопів, нелінійність, асиметрія; перехресні осі — перевстановленням</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>three rates or more, of both signs</source>
            <translation>три швидкості або більше, обох знаків</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g-sensitivity on the dividing head</source>
            <translation>g-чутливість на ділильній головці</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>how gravity shifts the zero of gyros</source>
            <translation>як сила тяжіння зміщує нуль гіроскопів</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; four positions about one axis, eight for all three; the latitude for gyros that feel the Earth</source>
            <translation>g; чотири положення навколо однієї осі, вісім для всіх трьох; широта для гіроскопів, що відчувають Землю</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a table of the drift against time and chip temperature, for a microcontroller</source>
            <translation>таблиця дрейфу за часом і температурою кристала для мікроконтролера</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>about five turn-ons at each of several temperatures, at most 10 to 20 degC apart, cooled down between them</source>
            <translation>близько п'яти увімкнень за кожної з кількох температур, не далі ніж 10–20 °C одна від одної, з охолодженням між ними</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>heading of the base and systematic drift of the gyro</source>
            <translation>курс основи і систематичний дрейф гіроскопа</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a gyro with far less drift than the level part of the Earth's rate; three headings or more, best in steps of 90 degrees; the tilt by an accelerometer; no pole</source>
            <translation>гіроскоп із дрейфом значно меншим за горизонтальну складову обертання Землі; три курси або більше, найкраще через 90 градусів; нахил за акселерометром; не полюс</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/design.py" />
            <source>state the white noise of the sensor (N of its Allan analysis)</source>
            <translation>вкажіть білий шум датчика (N з його аналізу Аллана)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>there is no method {method}; there are: {join}</source>
            <translation>методу {method} немає; є: {join}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>{title}: nothing can be predicted without a record; {needs}</source>
            <translation>{title}: без запису нічого передбачити не можна; {needs}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>{title} is for a {kind}, the sensor is a {kind2}</source>
            <translation>{title} — для {kind}, а датчик — {kind2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>the plan {id} is for another method than {title}</source>
            <translation>план {id} — для іншого методу, ніж {title}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>the plan {id} has no step {names}</source>
            <translation>план {id} не має кроку {names}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>no position is left</source>
            <translation>не лишилося жодного положення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a response to the square of the input (K2)</source>
            <translation>відгук на квадрат входу (K2)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>add positions between the upright ones, e.g. 45 degrees, or rates of half the size</source>
            <translation>додайте положення між прямими, напр. 45 градусів, або швидкості вдвічі менші</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a response to the cube of the input (K3)</source>
            <translation>відгук на куб входу (K3)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>add positions at 30 or 45 degrees, or rates of other sizes</source>
            <translation>додайте положення на 30 або 45 градусах або швидкості інших величин</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a response to the product of two inputs (k_xy)</source>
            <translation>відгук на добуток двох входів (k_xy)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>add positions at which both axes feel gravity, e.g. 45 degrees</source>
            <translation>додайте положення, де обидві осі відчувають силу тяжіння, напр. 45 градусів</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>{replace}: no position of this plan changes the input that shows it</source>
            <translation>{replace}: жодне положення цього плану не змінює входу, що це показує</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>as many positions as unknowns: any reading fits, so a wrong one would not be noticed; add a position, or measure one again</source>
            <translation>положень стільки, скільки невідомих: підходить будь-який показ, тож хибного не помітити; додайте положення або виміряйте одне знову</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>one temperature: how bias and scale factor change with it stays unknown</source>
            <translation>одна температура: як зміщення нуля і масштабний коефіцієнт змінюються з нею, лишається невідомим</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>no position comes twice: a drift while measuring passes for a property of the sensor; go back to the first position at the end</source>
            <translation>жодне положення не повторюється: дрейф під час вимірювання видається властивістю датчика; наприкінці поверніться до першого положення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a base that leans east or west moves the heading by tan(latitude) of its tilt; measure the tilt by an accelerometer</source>
            <translation>основа, нахилена на схід або захід, зсуває курс на tan(широти) її нахилу; виміряйте нахил акселерометром</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>only {dof} reading(s) more than unknowns: where the scatter must be found from the residuals, intervals are {student_t} u wide instead of 2 u</source>
            <translation>показів лише на {dof} більше, ніж невідомих: там, де розкид треба шукати із залишків, інтервали мають ширину {student_t} u замість 2 u</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>{words} hides in the other parameters; {remedy}</source>
            <translation>{words} ховається в інших параметрах; {remedy}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>gyros on rate table and dividing head, practicum (3.3)</source>
            <translation>гіроскопи на поворотному стенді і ділильній головці, практикум (3.3)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>the table run is in {unit}, the head run in {unit2}</source>
            <translation>серія стенда в {unit}, серія головки в {unit2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>no output stands in both runs: {join} and {join2}</source>
            <translation>жоден вихід не є в обох серіях: {join} і {join2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>{name} did not answer to the rate table</source>
            <translation>{name} не відповів на поворотний стенд</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the set rate is wrong, or something disturbed the accumulation</source>
            <translation>задана швидкість неправильна або щось порушило накопичення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the table stood still</source>
            <translation>стенд стояв</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the table was turned the wrong way, or the sign of the rate is wrong</source>
            <translation>стенд обертали в інший бік або знак швидкості неправильний</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>as if the table had turned for {ratio} % of the accumulation: it stopped or slowed down</source>
            <translation>наче стенд обертався лише {ratio} % накопичення: він зупинився або сповільнився</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>in {join}</source>
            <translation>у {join}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the set rate seems to be in {unit}</source>
            <translation>задана швидкість, здається, в {unit}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>row {rows}, {place} deg/s: the mean is {times} times less certain than in the other rows; the table changed its rate during the accumulation</source>
            <translation>рядок {rows}, {place} deg/s: середнє в {times} [раз|раза|разів] менш певне, ніж в інших рядках; стенд змінив швидкість під час накопичення</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>row {rows}, {place} deg/s: the output{who} stands for {implied} deg/s; {story}. Repeat this rate, or leave the row out</source>
            <translation>рядок {rows}, {place} deg/s: вихід{who} відповідає {implied} deg/s; {story}. Повторіть цю швидкість або вилучіть рядок</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>{channels}: at {rates} deg/s the output ({outputs}) no longer follows the rate; the sensor or its converter is at its limit. These rows are left out of the line</source>
            <translation>{channels}: при {rates} deg/s вихід ({outputs}) більше не йде за швидкістю; датчик або його перетворювач на межі. Ці рядки не входять до прямої</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>the rows are from {min} to {max} degC, and one line went through all of them; fit each temperature on its own</source>
            <translation>рядки від {min} до {max} °C, і через усі проведено одну пряму; оцініть кожну температуру окремо</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>Unequal scale factors of the two senses ({value} ppm) would look much the same; more rates near zero tell the two apart.</source>
            <translation>Нерівні масштабні коефіцієнти двох напрямів ({value} ppm) виглядали б майже так само; більше швидкостей біля нуля їх розрізнять.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor {value} {unit} has the opposite sign of the expected {expected}: the table was turned the wrong way, or the unit lay upside down</source>
            <translation>{channel}: масштабний коефіцієнт {value} {unit} має знак, протилежний очікуваному {expected}: стенд обертали в інший бік або виріб лежав догори дном</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor {value} {unit} is {found} % from the expected {expected}: another unit, range or channel?</source>
            <translation>{channel}: масштабний коефіцієнт {value} {unit} відрізняється на {found} % від очікуваного {expected}: інший виріб, діапазон чи канал?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: two rates always lie on a line, so nothing can contradict it; measure three or more</source>
            <translation>{channel}: дві швидкості завжди лежать на прямій, тож ніщо не може їй суперечити; виміряйте три або більше</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: no answer to the rate ({value} +/- {expanded} {unit}); another axis, or the table did not turn</source>
            <translation>{channel}: немає відповіді на швидкість ({value} +/- {expanded} {unit}); інша вісь, або стенд не обертався</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor is negative ({value} {unit}), which is legal; the output falls when the unit turns counter-clockwise seen from above</source>
            <translation>{channel}: масштабний коефіцієнт від'ємний ({value} {unit}), що припустимо; вихід спадає, коли виріб обертається проти годинникової стрілки, якщо дивитися зверху</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>the zero of {channel}</source>
            <translation>нульовий сигнал {channel}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>the errors of {len} sensors go together ({std} deg/s): the table is at fault, not the sensors. State the uncertainty of its rate, so that it weighs</source>
            <translation>похибки {len} [датчика|датчиків|датчиків] змінюються разом ({std} deg/s): винен стенд, а не датчики. Вкажіть невизначеність його швидкості, щоб вона враховувалась</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the straight line is rejected (p = {p_value}); a {shape} of {value} {unit} fits significantly better. It bends the characteristic by {abs} ppm of {full_scale} deg/s.{also}</source>
            <translation>{channel}: пряму відхилено (p = {p_value}); {shape} {value} {unit} підходить значно краще. Вона вигинає характеристику на {abs} ppm від {full_scale} deg/s.{also}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor is {found} times the expected one, which is the ratio of deg/s and {unit}: the rates or the outputs are in another unit</source>
            <translation>{channel}: масштабний коефіцієнт у {found} [раз|раза|разів] більший за очікуваний, а це відношення deg/s і {unit}: швидкості або виходи в інших одиницях</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_recognition.py" />
            <source>this is not {labels}: the outputs stand for {shown} deg/s; {story}</source>
            <translation>це не {labels}: виходи відповідають {shown} deg/s; {story}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>gyros on the rate table, practicum (3.4) to (3.6)</source>
            <translation>гіроскопи на поворотному стенді, практикум (3.4)–(3.6)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>{channel}: the same output in every row; the sensor is dead or not connected</source>
            <translation>{channel}: однаковий вихід у кожному рядку; датчик не працює або не під'єднаний</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>the outputs are the same in every row; nothing was measured</source>
            <translation>виходи однакові в кожному рядку; нічого не виміряно</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>row {row}: the output {channels} is not a number</source>
            <translation>рядок {row}: вихід {channels} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>every row has the same rate ({x} deg/s): neither the scale factor nor the zero can be told from it; measure at two rates or more, better eleven</source>
            <translation>у кожному рядку однакова швидкість ({x} deg/s): ні масштабного коефіцієнта, ні нульового сигналу з цього не видно; виміряйте дві швидкості або більше, краще одинадцять</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>{join}: no row turns about {axis}, their own axis</source>
            <translation>{join}: жоден рядок не обертається навколо {axis}, їхньої власної осі</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise.py" />
            <source>this looks like {names}, not {labels}</source>
            <translation>це схоже на {names}, а не на {labels}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise.py" />
            <source>this is not {labels} and fits no other position of the plan; the nearest is {labels2}. Check how the unit is mounted and the head angle</source>
            <translation>це не {labels} і не відповідає жодному іншому положенню плану; найближче — {labels2}. Перевірте, як установлено виріб, і кут головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise.py" />
            <source>{name} axis reversed: the signs fit {labels} with {name2} pointing the other way; turn the unit over, or change the polarity in its profile</source>
            <translation>вісь {name} навпаки: знаки відповідають {labels} з {name2} у протилежний бік; переверніть виріб або змініть полярність у його профілі</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise_angles.py" />
            <source>the unit tells a {kind} of {outputs} deg</source>
            <translation>виріб показує {kind} {outputs} deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise_angles.py" />
            <source>{told}: this looks like {names}, not {labels}</source>
            <translation>{told}: це схоже на {names}, а не на {labels}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise_angles.py" />
            <source>{told}, which is not {labels} and no other position of the plan; check how the unit is mounted and the head angle</source>
            <translation>{told}, що не є {labels} і жодним іншим положенням плану; перевірте, як установлено виріб, і кут головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>the file does not hold the set angles; its rows were taken as {kind} {first}, ... of the practicum's list Angles</source>
            <translation>файл не містить заданих кутів; його рядки взято як {kind} {first}, ... зі списку Angles практикуму</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>the run does not hold the set angles; give them, e.g. 0,30,60</source>
            <translation>серія не містить заданих кутів; укажіть їх, напр. 0,30,60</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>{len} set angles were given for {len2} rows</source>
            <translation>дано {len} заданих кутів на {len2} [рядок|рядки|рядків]</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>pitch is set with X along the shaft, roll with Y; this run has neither</source>
            <translation>тангаж задають з X уздовж вала, крен — з Y; у цій серії немає ні того, ні іншого</translation>
        </message>
        <message>
            <location filename="../../core/procedures/six_position.py" />
            <source>the nine-parameter form of source 002 leaves {residual_mg} mg on {axes}, the twelve parameters {left_mg} mg: the sensor block is turned by {angle} deg in the platform, for which that form has no parameter</source>
            <translation>дев'ятипараметрична форма джерела 002 залишає {residual_mg} mg на {axes}, дванадцять параметрів — {left_mg} mg: блок датчиків повернутий на {angle} deg у платформі, для чого ця форма не має параметра</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>sensors over temperature, source 002 (4) to (7)</source>
            <translation>датчики за температурою, джерело 002 (4)–(7)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>all rows were measured at {temperature_c} degC; a dependence on temperature needs two temperatures, to test one three</source>
            <translation>усі рядки виміряно при {temperature_c} °C; для залежності від температури потрібні дві температури, для її перевірки — три</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>the {axis} axis felt the same in all rows, where a change of the scale factor with temperature reads as one of the bias; measure it up and down at each temperature</source>
            <translation>вісь {axis} відчувала те саме в усіх рядках, де зміна масштабного коефіцієнта з температурою читається як зміна зміщення нуля; виміряйте її вгору і вниз за кожної температури</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>{min} ... {max} degC leaves the measured {low_c} ... {high_c} degC; polynomials mean nothing outside</source>
            <translation>{min} ... {max} °C виходить за виміряне {low_c} ... {high_c} °C; поліноми там нічого не означають</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>order {order} needs {order2} temperatures ({order3} to test it), there are {levels}</source>
            <translation>порядок {order} потребує {order2} [температури|температур|температур] ({order3} для перевірки), є {levels}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>two temperatures give a straight line that nothing can contradict; measure a third between them</source>
            <translation>дві температури дають пряму, якій ніщо не може суперечити; виміряйте третю між ними</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>at {join} degC an axis did not stand both up and down; there the scale factor is taken from the other temperatures</source>
            <translation>при {join} °C якась вісь не стояла і вгору, і вниз; там масштабний коефіцієнт узято з інших температур</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>{channel}: at {temperature_c} degC the bias reached by heating is {value} {unit} from that reached by cooling; no function of the temperature can compensate that</source>
            <translation>{channel}: при {temperature_c} °C зміщення нуля, досягнуте нагріванням, відрізняється на {value} {unit} від досягнутого охолодженням; жодна функція температури цього не скомпенсує</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>the runs are of {join}; is it one unit?</source>
            <translation>серії від {join}; чи це один виріб?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>the runs state different g: {join} m/s^2</source>
            <translation>серії вказують різні g: {join} m/s^2</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>there is no run</source>
            <translation>немає жодної серії</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>{words}; that of the first is taken</source>
            <translation>{words}; узято з першої</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>{device} and {device2} differ in {what}: {getattr} and {getattr2}; one set needs one unit, measured alike</source>
            <translation>{device} і {device2} відрізняються: {what}: {getattr} і {getattr2}; один набір потребує одного виробу, виміряного однаково</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/over_temperature.py" />
            <source>Temperature sensitivity</source>
            <translation>Температурна чутливість</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/over_temperature.py" />
            <source>parameters change with the temperature</source>
            <translation>параметри змінюються з температурою</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/plateaus.py" />
            <source>row {missing}: the temperature is missing; a run over temperature needs it in every row</source>
            <translation>рядок {missing}: немає температури; серія за температурою потребує її в кожному рядку</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>order {order}; the record allows 0 to {highest}</source>
            <translation>порядок {order}; запис допускає від 0 до {highest}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>{len} rows; a record over temperature needs at least {fewest_rows}</source>
            <translation>{len} [рядок|рядки|рядків]; запис за температурою потребує щонайменше {fewest_rows}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>the temperature stayed between {min} and {max} degC; a dependence on it needs a span of {span_c} degC or more</source>
            <translation>температура лишалася між {min} і {max} °C; для залежності від неї потрібен розмах {span_c} °C або більше</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>{temperature_c} degC is outside the measured {low_c} ... {high_c} degC; polynomials mean nothing there</source>
            <translation>{temperature_c} °C поза виміряним {low_c} ... {high_c} °C; поліноми там нічого не означають</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>row {bad}: the {what} is not a number</source>
            <translation>рядок {bad}: {what} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>the unit stood in one orientation: an axis that feels a part of g shows the change of its scale factor as one of its bias; measure positions at each temperature to tell them apart</source>
            <translation>виріб стояв в одному положенні: вісь, що відчуває частину g, показує зміну масштабного коефіцієнта як зміну зміщення нуля; виміряйте положення за кожної температури, щоб їх розрізнити</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>{channel}: at {hysteresis_at_c} degC the output while heating is {value} {unit} from that while cooling: lag, hysteresis or a drift in time, which no polynomial of the temperature can compensate</source>
            <translation>{channel}: при {hysteresis_at_c} °C вихід під час нагрівання відрізняється на {value} {unit} від виходу під час охолодження: запізнення, гістерезис або дрейф у часі, чого поліном температури не скомпенсує</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/simulated.py" />
            <source>simulated triad</source>
            <translation>симульована тріада</translation>
        </message>
        <message>
            <location filename="../../core/procedures/triad.py" />
            <source>axes {join} are no triad; each of x, y, z is needed once</source>
            <translation>осі {join} не є тріадою; кожна з x, y, z потрібна один раз</translation>
        </message>
        <message>
            <location filename="../../core/procedures/triad.py" />
            <source>the matrix K is singular: two sensors feel the same axis</source>
            <translation>матриця K вироджена: два датчики відчувають ту саму вісь</translation>
        </message>
        <message>
            <location filename="../../core/procedures/triad.py" />
            <source>the {axis} sensor has no parameter {error}</source>
            <translation>датчик {axis} не має параметра {error}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>the table file is of {table}, the head file of {head}: scale factor and zero of two units do not belong together.</source>
            <translation>файл стенда від {table}, файл головки від {head}: масштабний коефіцієнт і нульовий сигнал двох виробів не поєднуються.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>; another day, another temperature, or another unit?</source>
            <translation>; інший день, інша температура чи інший виріб?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>{channel}: the zero is {value} {unit} on the table, while the head lets expect {predicted}; (3.10) puts {value2} deg/s into every rate{why}</source>
            <translation>{channel}: нульовий сигнал на стенді {value} {unit}, а за головкою очікується {predicted}; (3.10) додає {value2} deg/s до кожної швидкості{why}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>the table run was at {mean} degC, the head run at {mean2} degC: the zero moves with temperature.</source>
            <translation>серія стенда була при {mean} °C, серія головки — при {mean2} °C: нульовий сигнал змінюється з температурою.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>{name}: the first {x} temperatures of the two files are the same digit for digit; one of them was copied, so they cannot tell whether the runs were alike.</source>
            <translation>{name}: перші {x} [температури|температур|температур] двох файлів збігаються цифра в цифру; одну з них скопійовано, тож вони не кажуть, чи були серії однаковими.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>{name}: the head run was {apart} codes from the table run: the zero moves with temperature.</source>
            <translation>{name}: серія головки відрізняється на {apart} [код|коди|кодів] від серії стенда: нульовий сигнал змінюється з температурою.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>position {number} ({head_deg} deg)</source>
            <translation>положення {number} ({head_deg} deg)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>rate {number} ({rate_dps} deg/s)</source>
            <translation>швидкість {number} ({rate_dps} deg/s)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>heading {number} ({head_deg} deg)</source>
            <translation>курс {number} ({head_deg} deg)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>the device sends no sensor output that the plan {title} could measure</source>
            <translation>пристрій не передає виходу датчика, який міг би виміряти план {title}</translation>
        </message>
        <message>
            <location filename="../../core/records/atomic.py" />
            <source>free some disk space or choose another folder, then save again</source>
            <translation>звільніть місце на диску або виберіть іншу теку, потім збережіть знову</translation>
        </message>
        <message>
            <location filename="../../core/records/atomic.py" />
            <source>{path}: cannot be written ({strerror}); {saved}; {remedy}</source>
            <translation>{path}: неможливо записати ({strerror}); {saved}; {remedy}</translation>
        </message>
        <message>
            <location filename="../../core/records/atomic.py" />
            <source>what stood there before is untouched</source>
            <translation>те, що там було раніше, не зачеплено</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>U in {unit}, {symbol} in {unit2}</source>
            <translation>U у {unit}, {symbol} у {unit2}</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>+ e, the added effects</source>
            <translation>+ e, додані ефекти</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>accelerometer or gyro</source>
            <translation>акселерометр або гіроскоп</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>at least one channel</source>
            <translation>щонайменше один канал</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>x, y, z or empty</source>
            <translation>x, y, z або порожньо</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>an identifier of the catalogue</source>
            <translation>ідентифікатор каталогу</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>names of parameters of the fit</source>
            <translation>назви параметрів оцінки</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>at least one parameter</source>
            <translation>щонайменше один параметр</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>{where}: a parameter has no value</source>
            <translation>{where}: параметр не має значення</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>The last row is incomplete, as after a power cut, and is left out.</source>
            <translation>Останній рядок неповний, як після зникнення живлення; його пропущено.</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>{per_line} values; the head names {len} channels</source>
            <translation>{per_line} [значення|значення|значень]; заголовок називає {len} [канал|канали|каналів]</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>holds no rows</source>
            <translation>не містить рядків</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>no file of CVGCom: its head has no line {names_key}</source>
            <translation>не файл CVGCom: у заголовку немає рядка {names_key}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>{names_key} has {len} names, {count_key} is {count}</source>
            <translation>{names_key} має {len} [назву|назви|назв], {count_key} дорівнює {count}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>{time_key} is {sampling}; must be above zero</source>
            <translation>{time_key} дорівнює {sampling}; має бути більше нуля</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>the head has no line {key}</source>
            <translation>у заголовку немає рядка {key}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom_writer.py" />
            <source>{path}: cannot be created: {strerror}</source>
            <translation>{path}: неможливо створити: {strerror}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom_writer.py" />
            <source>{path}: cannot be written: {strerror}</source>
            <translation>{path}: неможливо записати: {strerror}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom_writer.py" />
            <source>{path}: not safe on disk: {strerror}</source>
            <translation>{path}: не збережено надійно на диску: {strerror}</translation>
        </message>
        <message>
            <location filename="../../core/records/decimals.py" />
            <source>{shown} is no number</source>
            <translation>{shown} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>correction_at_{value}_degC ({unit})</source>
            <translation>correction_at_{value}_degC ({unit})</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>C header with int16 table</source>
            <translation>Заголовок C з таблицею int16</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>JSON with scores and provenance</source>
            <translation>JSON з оцінками і походженням</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>CSV of the table</source>
            <translation>CSV таблиці</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>added to {name}: {name2}, {equation}; {reach}</source>
            <translation>додано до {name}: {name2}, {equation}; {reach}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>device: {device}, {sensor}</source>
            <translation>device: {device}, {sensor}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>equation: {equation}</source>
            <translation>equation: {equation}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>procedure: {procedure}</source>
            <translation>procedure: {procedure}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>profile: {profile}; plan: {plan}</source>
            <translation>profile: {profile}; plan: {plan}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>local g: {g_mps2} m/s^2</source>
            <translation>local g: {g_mps2} m/s^2</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>temperature: {temperature_c} degC</source>
            <translation>temperature: {temperature_c} degC</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>measured: {measured_utc}</source>
            <translation>measured: {measured_utc}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>computed: {computed_utc} by {software}</source>
            <translation>computed: {computed_utc} by {software}</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>data: {name}, SHA-256 {sha}</source>
            <translation>data: {name}, SHA-256 {sha}</translation>
        </message>
        <message>
            <location filename="../../core/records/exports.py" />
            <source>JSON with covariance and provenance</source>
            <translation>JSON з коваріацією і походженням</translation>
        </message>
        <message>
            <location filename="../../core/records/exports.py" />
            <source>C header</source>
            <translation>Заголовок C</translation>
        </message>
        <message>
            <location filename="../../core/records/exports.py" />
            <source>MATLAB file</source>
            <translation>Файл MATLAB</translation>
        </message>
        <message>
            <location filename="../../core/records/exports.py" />
            <source>CSV with decimal comma, for Excel</source>
            <translation>CSV з десятковою комою, для Excel</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} holds the test {test}; it tells nothing that is compared</source>
            <translation>{name} містить випробування {test}; у ньому нема чого порівнювати</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} is a calibration of accelerometers; gyros are compared here</source>
            <translation>{name} — калібрування акселерометрів; тут порівнюють гіроскопи</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} holds accelerometers; gyros are compared here</source>
            <translation>{name} містить акселерометри; тут порівнюють гіроскопи</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} holds no noise of a gyro in deg/s; state its scale factor</source>
            <translation>{name} не містить шуму гіроскопа в deg/s; вкажіть його масштабний коефіцієнт</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name}: the {replace} of {source} is in {unit}; its scale factor is missing: add a run on the rate table</source>
            <translation>{name}: {replace} з {source} у {unit}; його масштабного коефіцієнта немає: додайте серію на поворотному стенді</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>is no table of noise coefficients: {error}</source>
            <translation>не таблиця коефіцієнтів шуму: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name}: two files differ in the {replace} by {apart} standard uncertainties; that of {source} is shown</source>
            <translation>{name}: два файли різняться в {replace} на {apart} стандартних невизначеностей; показано значення з {source}</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{device} {channel}: the {replace} was not detected, it is below {upper} {noise} (95 %)</source>
            <translation>{device} {channel}: {replace} не виявлено, воно менше за {upper} {noise} (95 %)</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>is no {schema} document (schema = {found})</source>
            <translation>не документ {schema} (schema = {found})</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>was written by a newer CalRig ({schema} version {number}; this program reads up to version {version}): update CalRig</source>
            <translation>записано новішою версією CalRig ({schema}, версія {number}; ця програма читає до версії {version}): оновіть CalRig</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>is no JSON object</source>
            <translation>не об'єкт JSON</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{place} must be {wanted}, found {shown}</source>
            <translation>{place} має бути {wanted}, знайдено {shown}</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>damaged JSON: {msg}</source>
            <translation>пошкоджений JSON: {msg}</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>damaged JSON: {error}</source>
            <translation>пошкоджений JSON: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a moment such as 2024-05-13T14:05:00+03:00</source>
            <translation>момент на кшталт 2024-05-13T14:05:00+03:00</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>true or false</source>
            <translation>true або false</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a whole number</source>
            <translation>ціле число</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{size} numbers</source>
            <translation>{size} [число|числа|чисел]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{len} items</source>
            <translation>{len} [елемент|елементи|елементів]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{len} rows</source>
            <translation>{len} [рядок|рядки|рядків]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>an object</source>
            <translation>об'єкт</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a list</source>
            <translation>список</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{place} is missing</source>
            <translation>{place} відсутнє</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a number</source>
            <translation>число</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{columns} numbers</source>
            <translation>{columns} [число|числа|чисел]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a text, a number or true or false</source>
            <translation>текст, число або true чи false</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>set temperature</source>
            <translation>задана температура</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>head angle</source>
            <translation>кут головки</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>position number</source>
            <translation>номер положення</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>rate number</source>
            <translation>номер швидкості</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>row number</source>
            <translation>номер рядка</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>holds no rows of {device}, only of {join}</source>
            <translation>не містить рядків {device}, лише {join}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>{title} holds no {sensor}</source>
            <translation>{title} не містить {sensor}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>mounts are given, but the numbers of {title} already tell them</source>
            <translation>встановлення задано, але номери {title} вже їх визначають</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>every {sensor} output is zero: nothing was measured</source>
            <translation>кожен вихід {sensor} дорівнює нулю: нічого не виміряно</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>{path}: positions 5 to 12 of Pointer are not described in the practicum; they are taken as {join}</source>
            <translation>{path}: положення Pointer від 5 до 12 не описано в практикумі; їх узято як {join}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>holds rows of {len} devices ({join}): say which one</source>
            <translation>містить рядки {len} [пристрою|пристроїв|пристроїв] ({join}): скажіть, якого</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>OpticalDividingHead of ClbAcc (Table 1.2)</source>
            <translation>OpticalDividingHead програми ClbAcc (таблиця 1.2)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>OpticalDividingHead of Pointer (Table 2.2)</source>
            <translation>OpticalDividingHead програми Pointer (таблиця 2.2)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>OpticalDividingHead of ClbDUS (Table 3.3)</source>
            <translation>OpticalDividingHead програми ClbDUS (таблиця 3.3)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>RotationTable of ClbDUS (Table 3.2)</source>
            <translation>RotationTable програми ClbDUS (таблиця 3.2)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>Accuracy of Pointer (Table 2.4)</source>
            <translation>Accuracy програми Pointer (таблиця 2.4)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>Accuracy of Pointer, the 15 columns that Table 2.4 prints</source>
            <translation>Accuracy програми Pointer, 15 стовпців, надрукованих у таблиці 2.4</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>{value} stands where the {name} must be a whole number</source>
            <translation>стоїть {value} там, де {name} має бути цілим числом</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>{value} stands where the {name} must be {span}</source>
            <translation>стоїть {value} там, де {name} має бути {span}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 3</source>
            <translation>стовпець 3</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>{low} to {high}</source>
            <translation>від {low} до {high}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>position number {position} does not belong to head angle {angle} deg (column 3), which is position {position_of}</source>
            <translation>номер положення {position} не належить куту головки {angle} deg (стовпець 3), який є положенням {position_of}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 5</source>
            <translation>стовпець 5</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 6</source>
            <translation>стовпець 6</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 4</source>
            <translation>стовпець 4</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>give the mounts, one a pass, e.g. X_from,Y_from, or one for all rows</source>
            <translation>вкажіть встановлення, по одному на прохід, напр. X_from,Y_from, або одне для всіх рядків</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>at each temperature</source>
            <translation>за кожної температури</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>one pass of angles{place} is taken as X_from</source>
            <translation>один прохід кутів{place} узято як X_from</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>the angles start over{place}, so that the first pass is taken as X_from and the second as Y_from</source>
            <translation>кути починаються знову{place}, тож перший прохід узято як X_from, а другий — як Y_from</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>{path}: the layout holds no mount; {text}</source>
            <translation>{path}: цей формат не містить встановлення; {text}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>{len} mounts are given, but {count}; {give}</source>
            <translation>дано {len} [встановлення|встановлення|встановлень], але {count}; {give}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>in {visits} stays at a temperature</source>
            <translation>за {visits} [зупинку|зупинки|зупинок] на температурі</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>{count}; this does not tell how the unit was mounted: {give}</source>
            <translation>{count}; це не каже, як було встановлено виріб: {give}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>head angle {angles} comes again before the angles start over: a repeated position, a sweep back or a re-mounted unit? {give}</source>
            <translation>кут головки {angles} повторюється раніше, ніж кути починаються знову: повторене положення, зворотний прохід чи перевстановлений виріб? {give}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/reader.py" />
            <source>is empty: no rows of measurements</source>
            <translation>порожній: немає рядків вимірювань</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>; this looks like columns parted by commas</source>
            <translation>; це схоже на стовпці, розділені комами</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>{len} columns, {title} has {width}</source>
            <translation>{len} [стовпець|стовпці|стовпців], {title} має {width}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>the rows fit {readings}; keep the beginning of the file's name (OpticalDividingHead_, RotationTable_, Accuracy_) or part the columns by tabs</source>
            <translation>рядки відповідають {readings}; збережіть початок назви файла (OpticalDividingHead_, RotationTable_, Accuracy_) або розділіть стовпці табуляцією</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>a row of another layout, {title}, among rows of {title2}; a file holds one layout</source>
            <translation>рядок іншого формату, {title}, серед рядків {title2}; файл містить один формат</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>{why} in {title}</source>
            <translation>{why} у {title}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>(the device's name may be the missing one)</source>
            <translation>(бракувати може назви пристрою)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>{title} with the name {name}</source>
            <translation>{title} з назвою {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>the columns are those of {title}, the name is that of {title2}: a damaged file, or a wrong name</source>
            <translation>стовпці як у {title}, а назва як у {title2}: пошкоджений файл або неправильна назва</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/rows.py" />
            <source>the column is empty</source>
            <translation>стовпець порожній</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/rows.py" />
            <source>{shown} is no measurement</source>
            <translation>{shown} не є вимірюванням</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/rows.py" />
            <source>{cell} has the decimal mark {mark}, the numbers before it have {first}; use one of them throughout</source>
            <translation>{cell} має десятковий знак {mark}, попередні числа — {first}; уживайте один з них усюди</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>holds rows of {title}, not of {title2}</source>
            <translation>містить рядки {title}, а не {title2}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} has no columns for a {sensor}</source>
            <translation>{title} не має стовпців для {sensor}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} holds the test {test}, this run is {test2}</source>
            <translation>{title} містить випробування {test}, ця серія — {test2}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>the run has no rows</source>
            <translation>серія не має рядків</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} needs outputs of axes x, y, z, this run has {axes}</source>
            <translation>{title} потребує виходів осей x, y, z, ця серія має {axes}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} holds {len} outputs, not {len2}</source>
            <translation>{title} містить {len} [вихід|виходи|виходів], а не {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>its earlier rows are untouched</source>
            <translation>його попередні рядки не зачеплено</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} needs the head angle of every row</source>
            <translation>{title} потребує кута головки для кожного рядка</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>row {row}: {title} has no position for mount {mount} at {angle} deg</source>
            <translation>рядок {row}: {title} не має положення для встановлення {mount} на {angle} deg</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>row {place}: {title} needs the {name}, which this run does not hold</source>
            <translation>рядок {place}: {title} потребує {name}, чого ця серія не містить</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>row {place}, column {column}: {doubt}</source>
            <translation>рядок {place}, стовпець {column}: {doubt}</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>holds no samples</source>
            <translation>не містить відліків</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>se {name}</source>
            <translation>se {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>holds no means</source>
            <translation>не містить середніх</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>no means after the name of the record</source>
            <translation>після назви запису немає середніх</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{len} records, {given} rates or positions for them</source>
            <translation>{len} [запис|записи|записів], {given} [швидкість|швидкості|швидкостей] або положень для них</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>has no output of a gyro</source>
            <translation>не має виходу гіроскопа</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>the records have different channels</source>
            <translation>записи мають різні канали</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{text} is no position; write X_from:90</source>
            <translation>{text} не є положенням; пишіть X_from:90</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{len} means; the first line has {len2}</source>
            <translation>{len} середніх; перший рядок має {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{text} is no number</source>
            <translation>{text} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{word} is no number</source>
            <translation>{word} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/records/names.py" />
            <source>No Name</source>
            <translation>Без назви</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>device channel term symbol method convention unit value u lower95 upper95 upper_limit</source>
            <translation>device channel term symbol method convention unit value u lower95 upper95 upper_limit</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>device channel unit regressed tau_s deviation lower upper edf model kind</source>
            <translation>device channel unit regressed tau_s deviation lower upper edf model kind</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>rostopic: /imu0</source>
            <translation>rostopic: /imu0</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>update_rate: {max}  # Hz</source>
            <translation>update_rate: {max}  # Hz</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Coefficients, CSV</source>
            <translation>Коефіцієнти, CSV</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Curves, CSV</source>
            <translation>Криві, CSV</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Kalibr imu.yaml</source>
            <translation>Kalibr imu.yaml</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Kalibr needs records in deg/s or m/s^2, not in {units}: state the scale factor</source>
            <translation>Kalibr потребує записів у deg/s або m/s^2, а не в {units}: вкажіть масштабний коефіцієнт</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>the records have different rates ({said}): choose those of one device</source>
            <translation>записи мають різні частоти ({said}): виберіть записи одного пристрою</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>, upper limit: not detected</source>
            <translation>, верхня межа: не виявлено</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>{sensor}_noise_density: {x}  # {density}, N two-sided</source>
            <translation>{sensor}_noise_density: {x}  # {density}, N two-sided</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>{sensor}_random_walk: {x}  # {walk}, K{doubt}</source>
            <translation>{sensor}_random_walk: {x}  # {walk}, K{doubt}</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>{device} {channel}: no noise model fits the record</source>
            <translation>{device} {channel}: жодна модель шуму не підходить до запису</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_study.py" />
            <source>{name} cannot be regressed on itself</source>
            <translation>{name} не можна регресувати на себе</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_study.py" />
            <source>only the curve is given: {error}</source>
            <translation>є лише крива: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_tables.py" />
            <source>random walk</source>
            <translation>випадкове блукання</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>is a JSON document, no measurements</source>
            <translation>документ JSON, а не вимірювання</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>mounts are given, but the rows already tell them</source>
            <translation>встановлення задано, але рядки вже їх визначають</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>holds no rows of {device}, only of {device2}</source>
            <translation>не містить рядків {device}, лише {device2}</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>holds outputs of the {sensor}, not of the {sensor2}</source>
            <translation>містить виходи {sensor}, а не {sensor2}</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>cannot be read: {why}</source>
            <translation>неможливо прочитати: {why}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_file.py" />
            <source>axes {join}; expected x, y or z for each output</source>
            <translation>осі {join}; для кожного виходу очікується x, y або z</translation>
        </message>
        <message>
            <location filename="../../core/records/run_file.py" />
            <source>a run of test {test} needs a column {name}</source>
            <translation>серія випробування {test} потребує стовпця {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_file.py" />
            <source>the further column {name} has the name of another one</source>
            <translation>додатковий стовпець {name} має назву іншого</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>holds no line of column names</source>
            <translation>не містить рядка з назвами стовпців</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>is no run file: the line '# {version_key} = 1' is missing</source>
            <translation>не файл серії: немає рядка '# {version_key} = 1'</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>was written by a newer CalRig (run file version {version}; this program reads up to version {version2}): update CalRig</source>
            <translation>записано новішою версією CalRig (файл серії версії {version}; ця програма читає до версії {version2}): оновіть CalRig</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>no TOML value: {error}</source>
            <translation>не значення TOML: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>{name} is given twice</source>
            <translation>{name} задано двічі</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>{key} is too large</source>
            <translation>{key} завелике</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>notes: expected {severity, subject, text}</source>
            <translation>notes: очікується {severity, subject, text}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>column {name}: {why}</source>
            <translation>стовпець {name}: {why}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>no column of outputs: y, or y_x, y_y, y_z</source>
            <translation>немає стовпця виходів: y або y_x, y_y, y_z</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{len} channels are named, {len2} outputs found</source>
            <translation>названо {len} [канал|канали|каналів], знайдено {len2} [вихід|виходи|виходів]</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>no CSV: {error}</source>
            <translation>не CSV: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>a column has no name</source>
            <translation>стовпець не має назви</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>column {name} comes twice</source>
            <translation>стовпець {name} трапляється двічі</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{cell} is no number</source>
            <translation>{cell} не є числом</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{name} is missing</source>
            <translation>{name} відсутнє</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{row} is no whole number</source>
            <translation>{row} не є цілим числом</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{len} cells, the names have {len2}</source>
            <translation>{len} [комірка|комірки|комірок], назв {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/series.py" />
            <source>holds no channel {name}; there are: {names}</source>
            <translation>не містить каналу {name}; є: {names}</translation>
        </message>
        <message>
            <location filename="../../core/records/series.py" />
            <source>{path} does not tell its sampling rate: state the samples per second</source>
            <translation>{path} не каже своєї частоти дискретизації: вкажіть кількість відліків за секунду</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: which channels are the outputs? There are: {names}</source>
            <translation>{path}: які канали є виходами? Є: {names}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: which channel is the temperature? There are: {names}</source>
            <translation>{path}: який канал є температурою? Є: {names}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{lost} of {rows} rows hold no number and were left out</source>
            <translation>{lost} з {rows} [рядка|рядків|рядків] не містять числа, їх пропущено</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: outputs in {join}; take those of one unit at a time</source>
            <translation>{path}: виходи в {join}; беріть виходи однієї одиниці за раз</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: samples were lost; gaps cannot be averaged over</source>
            <translation>{path}: втрачено відліки; через пропуски не можна усереднювати</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>there is no output {output}; there are: {join}</source>
            <translation>виходу {output} немає; є: {join}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>no row of numbers in the first {min} lines; is it a record?</source>
            <translation>немає рядка чисел у перших {min} рядках; чи це запис?</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>the first column has no name and increases by {float} each row: it is taken for the time in seconds</source>
            <translation>перший стовпець не має назви і зростає на {float} щорядка: його взято за час у секундах</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>holds a test {test}: rows of means, no record of samples</source>
            <translation>містить випробування {test}: рядки середніх, а не запис відліків</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>is empty: no samples</source>
            <translation>порожній: немає відліків</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>{len} cells, the rows before have {len2}</source>
            <translation>{len} [комірка|комірки|комірок], попередні рядки мають {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>holds time stamps only, no column of samples</source>
            <translation>містить лише позначки часу, жодного стовпця відліків</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>column {place}</source>
            <translation>стовпець {place}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/events.py" />
            <source>{where}.seconds is no number</source>
            <translation>{where}.seconds не є числом</translation>
        </message>
        <message>
            <location filename="../../core/records/session/events.py" />
            <source>event numbers</source>
            <translation>номери подій</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>line {line}, {size} bytes</source>
            <translation>рядок {line}, {size} [байт|байти|байтів]</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>{path}, line {line}: damaged ({size} bytes) and left out; whole events follow it: look at the file and the disk before using this session</source>
            <translation>{path}, рядок {line}: пошкоджено ({size} [байт|байти|байтів]) і пропущено; далі йдуть цілі події: перевірте файл і диск, перш ніж користуватися цим сеансом</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>{path}, line {number}</source>
            <translation>{path}, рядок {number}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>all positions accepted before are stored, this one is not</source>
            <translation>усі прийняті раніше положення збережено, це — ні</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>{path}, line {line}: the program ended while this was being written ({size} bytes); it was never confirmed and is left out, everything before it is whole</source>
            <translation>{path}, рядок {line}: програма завершилася під час запису ({size} [байт|байти|байтів]); його не було підтверджено, тож пропущено; усе попереднє ціле</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>what the session holds is untouched</source>
            <translation>те, що містить сеанс, не зачеплено</translation>
        </message>
        <message>
            <location filename="../../core/records/session/legacy_mirror.py" />
            <source>every position is stored in {folder}, but the text file for the old programs could not follow: {error}; it is made anew at the next change</source>
            <translation>кожне положення збережено в {folder}, але текстовий файл для старих програм не встиг за ним: {error}; його буде створено знову за наступної зміни</translation>
        </message>
        <message>
            <location filename="../../core/records/session/legacy_mirror.py" />
            <source>{path}: did not hold the rows of the journal and was made anew; the file as it was found is {name}</source>
            <translation>{path}: не містив рядків журналу і його створено знову; знайдений файл збережено як {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/lock.py" />
            <source>(process {who} on {who2} since {who3} UTC)</source>
            <translation>(процес {who} на {who2} з {who3} UTC)</translation>
        </message>
        <message>
            <location filename="../../core/records/session/lock.py" />
            <source>{parent}: another program is measuring into this session{holder}; continue there, or close it and open the session again</source>
            <translation>{parent}: інша програма вимірює в цей сеанс{holder}; продовжуйте там або закрийте її й відкрийте сеанс знову</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>no position has been accepted yet</source>
            <translation>ще не прийнято жодного положення</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>the device has no {sensor} that gives other than zero</source>
            <translation>пристрій не має {sensor}, що дає щось, крім нуля</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>the computer's clock was set back between positions {number} and {number2} ({one}, then {other} UTC): their order is right, their times are not; do not judge drift by them</source>
            <translation>годинник комп'ютера переведено назад між положеннями {number} і {number2} ({one}, потім {other} UTC): їх порядок правильний, а час — ні; не судіть за ним про дрейф</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>position {number}: {text}</source>
            <translation>положення {number}: {text}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>{journal}: events are missing or doubled (numbers {gaps}); somebody changed the file, or the disk lost a part of it</source>
            <translation>{journal}: події відсутні або подвоєні (номери {gaps}); хтось змінив файл або диск втратив його частину</translation>
        </message>
        <message>
            <location filename="../../core/records/session/start.py" />
            <source>one of {join} or empty</source>
            <translation>одне з {join} або порожньо</translation>
        </message>
        <message>
            <location filename="../../core/records/session/start.py" />
            <source>profile.text does not have the stored hash: it was changed</source>
            <translation>profile.text не має збереженого хешу: його змінено</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>{folder}: already holds a session; open it, or choose another folder</source>
            <translation>{folder}: уже містить сеанс; відкрийте його або виберіть іншу теку</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>is no session: it holds no {start_name}</source>
            <translation>не сеанс: немає {start_name}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>the accumulation has other channels than the session</source>
            <translation>накопичення має інші канали, ніж сеанс</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>{title} holds the set temperature of every position</source>
            <translation>{title} містить задану температуру кожного положення</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>no positions of these numbers: {sorted}</source>
            <translation>немає положень з такими номерами: {sorted}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>nothing has been measured yet</source>
            <translation>ще нічого не виміряно</translation>
        </message>
        <message>
            <location filename="../../core/records/text.py" />
            <source>is larger than {max_bytes} MB: no table of means</source>
            <translation>більший за {max_bytes} MB: це не таблиця середніх</translation>
        </message>
        <message>
            <location filename="../../core/records/text.py" />
            <source>holds zero bytes: a binary or UTF-16 file; save it as UTF-8 text and load again</source>
            <translation>містить нульові байти: двійковий файл або UTF-16; збережіть його як текст UTF-8 і завантажте знову</translation>
        </message>
        <message>
            <location filename="../../core/records/text.py" />
            <source>is neither UTF-8 nor CP1251 text</source>
            <translation>не текст UTF-8 і не CP1251</translation>
        </message>
        <message>
            <location filename="../../core/records/thermal_exports.py" />
            <source>CSV of the coefficients</source>
            <translation>CSV коефіцієнтів</translation>
        </message>
        <message>
            <location filename="../../core/records/thermal_exports.py" />
            <source>a record in one orientation compensates this orientation only: no C header is written of it; measure positions at each temperature</source>
            <translation>запис в одному положенні компенсує лише це положення: заголовок C з нього не пишеться; виміряйте положення за кожної температури</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>of {wanted}</source>
            <translation>з {wanted}</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>cannot accumulate {seconds} s at {rate} samples/s</source>
            <translation>неможливо накопичувати {seconds} s при {rate} відліках/s</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>nothing has been accumulated</source>
            <translation>нічого не накопичено</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>{lost} of {lost2} samples were lost on the line; the mean is over the rest</source>
            <translation>втрачено на лінії {lost} з {lost2} [відліку|відліків|відліків]; середнє взято за рештою</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>{join}: the same number in all {x} samples; is the sensor alive, or its noise below one code?</source>
            <translation>{join}: те саме число в усіх {x} відліках; чи працює датчик, чи його шум менший за один код?</translation>
        </message>
        <message>
            <location filename="../../core/samples/run.py" />
            <source>{x} outputs, {len} names, {len2} axes</source>
            <translation>{x} [вихід|виходи|виходів], {len} [назва|назви|назв], {len2} [вісь|осі|осей]</translation>
        </message>
        <message>
            <location filename="../../core/samples/run.py" />
            <source>column {name} has {len} rows, y has {x}</source>
            <translation>стовпець {name} має {len} [рядок|рядки|рядків], y має {x}</translation>
        </message>
        <message>
            <location filename="../../core/version.py" />
            <source>CalRig {version}</source>
            <translation>CalRig {version}</translation>
        </message>
        <message>
            <location filename="../../drivers/counter.py" />
            <source>counter restarted</source>
            <translation>лічильник почався знову</translation>
        </message>
        <message>
            <location filename="../../drivers/encode.py" />
            <source>only finite values can be sent</source>
            <translation>надсилати можна лише скінченні значення</translation>
        </message>
        <message>
            <location filename="../../drivers/encode.py" />
            <source>there is no encoder for "{name}"</source>
            <translation>немає кодувальника для "{name}"</translation>
        </message>
        <message>
            <location filename="../../drivers/encode.py" />
            <source>data of shape {shape} for {columns} channels</source>
            <translation>дані форми {shape} для {columns} [каналу|каналів|каналів]</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>an expression has at most {longest} characters</source>
            <translation>вираз має щонайбільше {longest} [символ|символи|символів]</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>"{text}" has no finite value</source>
            <translation>"{text}" не має скінченного значення</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>only numbers, names of [params], + - * / ** and () are allowed</source>
            <translation>дозволено лише числа, назви з [params], + - * / ** і ()</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>"{text}" is no expression: {msg}</source>
            <translation>"{text}" не є виразом: {msg}</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>; did you mean "{close}"?</source>
            <translation>; можливо, "{close}"?</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>"{name}" is not in [params]{hint}</source>
            <translation>"{name}" немає в [params]{hint}</translation>
        </message>
        <message>
            <location filename="../../drivers/fields.py" />
            <source>no field "{name}"</source>
            <translation>немає поля "{name}"</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>no CalRig record: it does not begin with CALREC1</source>
            <translation>не запис CalRig: не починається з CALREC1</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>the header of the record is damaged</source>
            <translation>заголовок запису пошкоджено</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>the header of the record is damaged: it is no JSON object</source>
            <translation>заголовок запису пошкоджено: не об'єкт JSON</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>the header of the record is damaged: {error}</source>
            <translation>заголовок запису пошкоджено: {error}</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: assembly of nine accelerometers (ClbAcc)</source>
            <translation>Симульований стенд: збірка з дев'яти акселерометрів (ClbAcc)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: attitude unit PW09 (Pointer)</source>
            <translation>Симульований стенд: блок орієнтації PW09 (Pointer)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: assembly of MEMS gyros (ClbDUS)</source>
            <translation>Симульований стенд: збірка MEMS-гіроскопів (ClbDUS)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: vibratory gyro CVG25 (CVGCom)</source>
            <translation>Симульований стенд: вібраційний гіроскоп CVG25 (CVGCom)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>the adapter is not plugged in</source>
            <translation>адаптер не під'єднано</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>plug it in again</source>
            <translation>під'єднайте його знову</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>this program reads schema {schema}, not {schema2}</source>
            <translation>ця програма читає схему {schema}, а не {schema2}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>exactly one of [frame], [line], [protocol] is needed, not {len}</source>
            <translation>потрібна рівно одна з [frame], [line], [protocol], а не {len}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>[[field]] belongs to a [frame]</source>
            <translation>[[field]] належить до [frame]</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>must not be negative</source>
            <translation>не може бути від'ємним</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>{needed}, which "{name}" needs, is missing or zero</source>
            <translation>{needed}, потрібне "{name}", відсутнє або нульове</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>the frame has no checksum to append</source>
            <translation>кадр не має контрольної суми для додавання</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>a command needs either hex or ascii</source>
            <translation>команда потребує hex або ascii</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>a command needs at least one byte</source>
            <translation>команда потребує щонайменше одного байта</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>the checksum is not at the end of a frame</source>
            <translation>контрольна сума не в кінці кадру</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>is no regular expression: {error}</source>
            <translation>не регулярний вираз: {error}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>"{name}" is used twice</source>
            <translation>"{name}" ужито двічі</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>from and to cover no byte</source>
            <translation>from і to не охоплюють жодного байта</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>at {at} leaves no room for {size} bytes</source>
            <translation>на {at} не лишається місця для {size} [байта|байтів|байтів]</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>from and to cover the checksum itself</source>
            <translation>from і to охоплюють саму контрольну суму</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>sum16w needs an even number of bytes, from and to give {len}</source>
            <translation>sum16w потребує парної кількості байтів, from і to дають {len}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must not be empty</source>
            <translation>не може бути порожнім</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must list at least one baud rate between 50 and 20000000</source>
            <translation>має перелічити щонайменше одну швидкість від 50 до 20000000 бод</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be like "8N1" (data bits, N/E/O, stop bits), not "{form}"</source>
            <translation>має бути як "8N1" (біти даних, N/E/O, стоп-біти), а не "{form}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be 1 to 8 bytes like "AA 55"; ".." stands for any byte</source>
            <translation>має бути від 1 до 8 байтів на кшталт "AA 55"; ".." означає будь-який байт</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must not begin with any byte</source>
            <translation>не може починатися з довільного байта</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be a number or an expression, not {value}</source>
            <translation>має бути числом або виразом, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>min must hold the length field, and max must not be below min</source>
            <translation>min має вміщати поле довжини, а max не може бути меншим за min</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>a name must not be empty</source>
            <translation>назва не може бути порожньою</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must name at least one value</source>
            <translation>має назвати щонайменше одне значення</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be [lowest, highest] within {kind}</source>
            <translation>має бути [найменше, найбільше] в межах {kind}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>can only be taken from an unsigned type</source>
            <translation>можна брати лише з беззнакового типу</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must not be zero</source>
            <translation>не може бути нулем</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be at most 4 bytes, none of them the first of sync</source>
            <translation>має бути щонайбільше 4 байти, жоден з них не перший байт sync</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>needs a checksum; without one let length include these bytes</source>
            <translation>потребує контрольної суми; без неї нехай length охоплює ці байти</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>needs at least one [[field]] that is not hidden</source>
            <translation>потребує щонайменше однієї [[field]], що не прихована</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>the fields name "{double}" twice</source>
            <translation>поля двічі називають "{double}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must hold {count} numbers or expressions, one a column</source>
            <translation>має містити {count} [число|числа|чисел] або виразів, по одному на стовпець</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>names a column twice</source>
            <translation>двічі називає стовпець</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must differ from the decimal mark</source>
            <translation>має відрізнятися від десяткового знака</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be given for style "{style}"</source>
            <translation>має бути задано для стилю "{style}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>{value} is not one of {allowed}</source>
            <translation>{value} не є одним із {allowed}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>has no "{name}", which this unit replaces</source>
            <translation>не має "{name}", яке ця одиниця замінює</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>"{text}" is no row of hexadecimal bytes</source>
            <translation>"{text}" не є рядком шістнадцяткових байтів</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>has {len} entries for {len2} names</source>
            <translation>має {len} [запис|записи|записів] на {len2} [назву|назви|назв]</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>"{role}" is no role</source>
            <translation>"{role}" не є роллю</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>"{role}" needs the unit {join}, not "{unit}"</source>
            <translation>"{role}" потребує одиниці {join}, а не "{unit}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>end at byte {end}, the frame has {shortest}</source>
            <translation>закінчуються на байті {end}, кадр має {shortest}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/cvg12.py" />
            <source>gyro {frame} of controller {frame2}</source>
            <translation>гіроскоп {frame} контролера {frame2}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/inertial.py" />
            <source>unknown 0x{message}</source>
            <translation>невідоме 0x{message}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/inertial.py" />
            <source>command 0x{command}</source>
            <translation>команда 0x{command}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/inertial.py" />
            <source>alignment report</source>
            <translation>звіт вирівнювання</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/stim300.py" />
            <source>external trigger</source>
            <translation>зовнішній запуск</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>hard fault</source>
            <translation>апаратна відмова</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>serial buffer overflow</source>
            <translation>переповнення буфера порту</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid checksum</source>
            <translation>неправильна контрольна сума</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid command</source>
            <translation>неправильна команда</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>not enough parameters</source>
            <translation>замало параметрів</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>too many parameters</source>
            <translation>забагато параметрів</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid parameter</source>
            <translation>неправильний параметр</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid register</source>
            <translation>неправильний регістр</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>unauthorized access</source>
            <translation>немає дозволу</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>watchdog reset</source>
            <translation>скидання сторожовим таймером</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>output buffer overflow</source>
            <translation>переповнення вихідного буфера</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>insufficient baud rate</source>
            <translation>недостатня швидкість порту</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>code {code}</source>
            <translation>код {code}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>register {words}</source>
            <translation>регістр {words}</translation>
        </message>
        <message>
            <location filename="../../drivers/rawlog.py" />
            <source>holds {get}; expected a raw log</source>
            <translation>містить {get}; очікується необроблений журнал</translation>
        </message>
        <message>
            <location filename="../../drivers/rawlog.py" />
            <source>not stored</source>
            <translation>не збережено</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>no data</source>
            <translation>немає даних</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>calrig reader</source>
            <translation>calrig reader</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>the driver does not let go of the port</source>
            <translation>драйвер не відпускає порт</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>unplug the adapter</source>
            <translation>від'єднайте адаптер</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>stopped by an error inside the program: {fault}</source>
            <translation>зупинено помилкою в програмі: {fault}</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>calrig recorder</source>
            <translation>calrig recorder</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>{path}: the disk has not taken the end of the record for {join_s} s</source>
            <translation>{path}: диск не прийняв кінець запису за {join_s} s</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>other channels</source>
            <translation>інші канали</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>{path}: the recorder was stopped by an error inside the program ({fault}); what it had stored before is whole: start a new record</source>
            <translation>{path}: запис зупинено помилкою в програмі ({fault}); те, що збережено раніше, ціле: почніть новий запис</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>link ended</source>
            <translation>зв'язок завершено</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>its samples have not the {len} channels of its header</source>
            <translation>його відліки не мають {len} [каналу|каналів|каналів] заголовка</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>the rate of its samples is not known</source>
            <translation>частота його відліків невідома</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>{count} bytes inside the file are damaged; what they held is a gap.</source>
            <translation>{count} [байт|байти|байтів] усередині файла пошкоджено; те, що вони містили, є пропуском.</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>The file ends within a block, as after a power cut; all before it is whole.</source>
            <translation>Файл закінчується всередині блока, як після зникнення живлення; усе попереднє ціле.</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>{refused} bytes found no room on the disk while recording.</source>
            <translation>{refused} [байт|байти|байтів] не вмістилися на диску під час запису.</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>the header names no channels</source>
            <translation>заголовок не називає каналів</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>holds no samples, and no profile that its bytes could be read by</source>
            <translation>не містить ні відліків, ні профілю, за яким можна прочитати його байти</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>was interrupted, and too little came to tell how long by</source>
            <translation>перервано, і прийшло замало, щоб сказати, на який час</translation>
        </message>
        <message>
            <location filename="../../drivers/records.py" />
            <source>holds no records of CVGCom and no recordings</source>
            <translation>не містить ні записів CVGCom, ні записів програми</translation>
        </message>
        <message>
            <location filename="../../drivers/series.py" />
            <source>the record was not ended in order; what stands in it is whole</source>
            <translation>запис не було завершено як слід; те, що в ньому є, ціле</translation>
        </message>
        <message>
            <location filename="../../drivers/series.py" />
            <source>holds no samples yet</source>
            <translation>ще не містить відліків</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/analysis.py" />
            <source>nothing was found that a device file could say</source>
            <translation>не знайдено нічого, що міг би сказати файл пристрою</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/checks.py" />
            <source>poly 0x{poly}</source>
            <translation>poly 0x{poly}</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/checks.py" />
            <source>init 0x{init}</source>
            <translation>init 0x{init}</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/checks.py" />
            <source>{endian} endian</source>
            <translation>{endian} endian</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/checks.py" />
            <source>xorout 0x{xorout}</source>
            <translation>xorout 0x{xorout}</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>the time in seconds</source>
            <translation>час у секундах</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>the time in milliseconds</source>
            <translation>час у мілісекундах</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>the time in microseconds</source>
            <translation>час у мікросекундах</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>{address} does not run in real time</source>
            <translation>{address} працює не в реальному часі</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>its bytes came faster than {baud} baud can carry</source>
            <translation>його байти надійшли швидше, ніж їх можуть передати {baud} бод</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>no times of its bytes are known</source>
            <translation>моменти надходження байтів невідомі</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>{doubt}, and none of its numbers is the time</source>
            <translation>{doubt}, і жодне з чисел не є часом</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>{doubt}; {name} is {unit}, by which it is {hz} a second</source>
            <translation>{doubt}; {name} - це {unit}, за чим виходить {hz} за секунду</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>is missing</source>
            <translation>відсутнє</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a text in quotes, not {value}</source>
            <translation>має бути текстом у лапках, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a whole number, not {value}</source>
            <translation>має бути цілим числом, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be between {low} and {high}, not {value}</source>
            <translation>має бути між {low} і {high}, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a finite number, not {value}</source>
            <translation>має бути скінченним числом, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be true or false, not {value}</source>
            <translation>має бути true або false, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a list, [...], not {value}</source>
            <translation>має бути списком, [...], а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>every entry must be a text in quotes</source>
            <translation>кожен елемент має бути текстом у лапках</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>every entry must be a whole number</source>
            <translation>кожен елемент має бути цілим числом</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a table, not {value}</source>
            <translation>має бути таблицею, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be [[{key}]] sections</source>
            <translation>має бути розділами [[{key}]]</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>is no key of this table{hint}</source>
            <translation>не є ключем цієї таблиці{hint}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port does not open: {text}</source>
            <translation>порт не відкривається: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>there is no such port: {text}</source>
            <translation>такого порту немає: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port vanished: {error}</source>
            <translation>порт зник: {error}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the adapter was unplugged or lost power; plug it in again</source>
            <translation>адаптер від'єднали або він втратив живлення; під'єднайте його знову</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port is busy: another program has it open</source>
            <translation>порт зайнятий: його відкрила інша програма</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>close that program and try again</source>
            <translation>закрийте ту програму і спробуйте знову</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>permission denied: this user may not open the port</source>
            <translation>немає дозволу: цей користувач не може відкрити порт</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>sudo usermod -aG dialout $USER, then log in again</source>
            <translation>sudo usermod -aG dialout $USER, потім увійдіть знову</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>there is no such port</source>
            <translation>такого порту немає</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>plug the adapter in and refresh the list</source>
            <translation>під'єднайте адаптер і оновіть список</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>nobody answers there: {text}</source>
            <translation>там ніхто не відповідає: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>check the address and the port</source>
            <translation>перевірте адресу і порт</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>onfigure port</source>
            <translation>onfigure port</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port does not take {baud} baud {form}, or is no serial port ({text})</source>
            <translation>порт не приймає {baud} baud {form} або не є послідовним ({text})</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>choose another baud rate or another port</source>
            <translation>виберіть іншу швидкість або інший порт</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port does not take {baud} baud ({text})</source>
            <translation>порт не приймає {baud} baud ({text})</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>choose another baud rate</source>
            <translation>виберіть іншу швидкість</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>there is no such port: {kind}:// is unknown</source>
            <translation>такого порту немає: {kind}:// невідомий</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>expected a port name, socket://, sim:// or replay://</source>
            <translation>очікується назва порту, socket://, sim:// або replay://</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the device takes no data</source>
            <translation>пристрій не приймає даних</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>check the cable and the flow control</source>
            <translation>перевірте кабель і керування потоком</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/address.py" />
            <source>unknown key {key}; there are {join}</source>
            <translation>невідомий ключ {key}; є {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>no device {device_id}; there are {join}</source>
            <translation>пристрою {device_id} немає; є {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>no effect {effect_id}; there are {join}</source>
            <translation>ефекту {effect_id} немає; є {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>effect {effect_id} acts between rows; a rig plays what acts at once</source>
            <translation>ефект {effect_id} діє між рядками; стенд грає те, що діє одразу</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>effect {effect_id} takes {len} values ({names})</source>
            <translation>ефект {effect_id} приймає {len} [значення|значення|значень] ({names})</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>no output {role}; there are {join}</source>
            <translation>виходу {role} немає; є {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>MiniAhrs 2.12</source>
            <translation>MiniAhrs 2.12</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/orders.py" />
            <source>unknown order {join}; there are {join2}</source>
            <translation>невідомий наказ {join}; є {join2}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/orders.py" />
            <source>stuck: there are {len} channels</source>
            <translation>stuck: каналів {len}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_replay.py" />
            <source>speed={query} must be above zero, or max</source>
            <translation>speed={query} має бути більше нуля або max</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_replay.py" />
            <source>there is no file {path}</source>
            <translation>файла {path} немає</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_sim.py" />
            <source>{url} is unplugged</source>
            <translation>{url} від'єднано</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_sim.py" />
            <source>{url} is open</source>
            <translation>{url} відкрито</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_sim.py" />
            <source>the simulated cable was pulled</source>
            <translation>симульований кабель висмикнули</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/rig.py" />
            <source>axis {axis}; expected x, y or z</source>
            <translation>вісь {axis}; очікується x, y або z</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/session.py" />
            <source>{group}, step {number}: {text}</source>
            <translation>{group}, крок {number}: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/session.py" />
            <source>the rig ended</source>
            <translation>стенд завершив роботу</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/truth.py" />
            <source>{held} of {len} intervals (95 %) hold the truth</source>
            <translation>{held} з {len} [інтервалу|інтервалів|інтервалів] (95 %) містять істинне значення</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>column</source>
            <translation>стовпець</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>done</source>
            <translation>готово</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>heading</source>
            <translation>курс</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>headings</source>
            <translation>курси</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>line</source>
            <translation>рядок</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>now</source>
            <translation>зараз</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>problem</source>
            <translation>несправність</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>rate</source>
            <translation>швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>rates</source>
            <translation>швидкості</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>row</source>
            <translation>рядок</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>turn-on</source>
            <translation>увімкнення</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>session</source>
            <translation>сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>calibration</source>
            <translation>калібрування</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>legacy</source>
            <translation>старий файл</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>record</source>
            <translation>запис</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>means</source>
            <translation>середні</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>noise</source>
            <translation>шум</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>finished</source>
            <translation>завершено</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>open</source>
            <translation>не завершено</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>good</source>
            <translation>добре</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>doubt</source>
            <translation>сумнів</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>bad</source>
            <translation>хибні</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>damaged</source>
            <translation>пошкоджено</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>bias</source>
            <translation>зміщення нуля</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>differs</source>
            <translation>відрізняється</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>cross axis x</source>
            <translation>поперечна вісь x</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>cross axis y</source>
            <translation>поперечна вісь y</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>cross axis z</source>
            <translation>поперечна вісь z</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Saturation</source>
            <translation>Насичення</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Warm-up</source>
            <translation>Прогрівання</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Outlier</source>
            <translation>Викид</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Drop-outs</source>
            <translation>Пропуски</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Clipping</source>
            <translation>Обмеження</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Hysteresis</source>
            <translation>Гістерезис</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} files</source>
            <translation>файлів: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} headings</source>
            <translation>курсів: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} positions</source>
            <translation>положень: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} rates</source>
            <translation>швидкостей: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} rows</source>
            <translation>рядків: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} samples</source>
            <translation>відліків: {n}</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_4.toml" />
            <source>4 positions about X</source>
            <translation>4 положення навколо X</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_4.toml" />
            <source>Rotation Around X axis, X from ODH</source>
            <translation>Rotation Around X axis, X from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_8.toml" />
            <source>8 positions about X and Y</source>
            <translation>8 положень навколо X і Y</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_8.toml" />
            <source>Rotation Around Y axis, Y from ODH</source>
            <translation>Rotation Around Y axis, Y from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/clbacc_24.toml" />
            <source>15-degree steps, about X and Y</source>
            <translation>Кроки по 15 градусів, навколо X і Y</translation>
        </message>
        <message>
            <location filename="../../resources/plans/drift_turn_on.toml" />
            <source>5 turn-ons at each temperature, drift after switching on</source>
            <translation>5 увімкнень за кожної температури, дрейф після увімкнення</translation>
        </message>
        <message>
            <location filename="../../resources/plans/drift_turn_on.toml" />
            <source>Turn-ons, unit at rest</source>
            <translation>Увімкнення, виріб у спокої</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_400.toml" />
            <source>Fourier tumble, 5 to 400 deg by 5</source>
            <translation>Оберт за Фур'є, від 5 до 400 deg через 5</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_400.toml" />
            <source>Tumble about Z, X level at 0</source>
            <translation>Оберт навколо Z, X горизонтально на 0</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_flip.toml" />
            <source>Fourier tumble, upright and turned over, 15 to 375 deg by 15</source>
            <translation>Оберт за Фур'є, прямо і перевернуто, від 15 до 375 deg через 15</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_flip.toml" />
            <source>Upright: Y up at 0</source>
            <translation>Прямо: Y вгору на 0</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_flip.toml" />
            <source>Turned over: Y down at 0</source>
            <translation>Перевернуто: Y вниз на 0</translation>
        </message>
        <message>
            <location filename="../../resources/plans/g_sensitivity_4.toml" />
            <source>g-sensitivity of gyros, 4 positions about X</source>
            <translation>g-чутливість гіроскопів, 4 положення навколо X</translation>
        </message>
        <message>
            <location filename="../../resources/plans/g_sensitivity_8.toml" />
            <source>g-sensitivity of gyros, 8 positions about X and Y</source>
            <translation>g-чутливість гіроскопів, 8 положень навколо X і Y</translation>
        </message>
        <message>
            <location filename="../../resources/plans/gyrocompass_4.toml" />
            <source>Gyrocompass, steps of 90 deg</source>
            <translation>Гірокомпас, кроки по 90 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/gyrocompass_4.toml" />
            <source>Gyro on a level base, input axis level</source>
            <translation>Гіроскоп на горизонтальній основі, вхідна вісь горизонтально</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy.toml" />
            <source>Accuracy, pitch 0 to 360 deg</source>
            <translation>Точність, тангаж від 0 до 360 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy.toml" />
            <source>Pitch, X from ODH</source>
            <translation>Тангаж, X from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy_3.toml" />
            <source>Accuracy, pitch 0, 30, 60 deg</source>
            <translation>Точність, тангаж 0, 30, 60 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy_45.toml" />
            <source>Accuracy, pitch 0 to 360 deg by 45</source>
            <translation>Точність, тангаж від 0 до 360 deg через 45</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pointer_16.toml" />
            <source>Pointer, 16 positions</source>
            <translation>Pointer, 16 положень</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pointer_16.toml" />
            <source>Rotation Around X axis, X to ODH</source>
            <translation>Rotation Around X axis, X to ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pointer_16.toml" />
            <source>Rotation Around Y axis, Y to ODH</source>
            <translation>Rotation Around Y axis, Y to ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pointer_8.toml" />
            <source>Pointer, positions 1-4 and 13-16</source>
            <translation>Pointer, положення 1-4 і 13-16</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_100.toml" />
            <source>Rate table, -100 to 100 deg/s, about Z</source>
            <translation>Поворотний стенд, від -100 до 100 deg/s, навколо Z</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_100.toml" />
            <source>Rotation Around Axis, Z up</source>
            <translation>Rotation Around Axis, Z up</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_cvg40.toml" />
            <source>Rate table, -40 to 40 deg/s, about Z, for a CVG</source>
            <translation>Поворотний стенд, від -40 до 40 deg/s, навколо Z, для CVG</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Rate table, up and down twice, -100 to 100 deg/s, about Z</source>
            <translation>Поворотний стенд, двічі вгору і вниз, від -100 до 100 deg/s, навколо Z</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Rising rates, first sweep, Z up</source>
            <translation>Зростання швидкостей, перший прохід, Z вгору</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Falling rates, first sweep, Z up</source>
            <translation>Спадання швидкостей, перший прохід, Z вгору</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Rising rates, second sweep, Z up</source>
            <translation>Зростання швидкостей, другий прохід, Z вгору</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Falling rates, second sweep, Z up</source>
            <translation>Спадання швидкостей, другий прохід, Z вгору</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_xyz.toml" />
            <source>Rate table, all three axes by re-mounting, -100 to 100 deg/s</source>
            <translation>Поворотний стенд, усі три осі перевстановленням, від -100 до 100 deg/s</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_xyz.toml" />
            <source>Rotation Around X, X up</source>
            <translation>Rotation Around X, X up</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_xyz.toml" />
            <source>Rotation Around Y, Y up</source>
            <translation>Rotation Around Y, Y up</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_xyz.toml" />
            <source>Rotation Around Z, Z up</source>
            <translation>Rotation Around Z, Z up</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy.toml" />
            <source>Accuracy, roll 0 to 360 deg</source>
            <translation>Точність, крен від 0 до 360 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy.toml" />
            <source>Roll, Y from ODH</source>
            <translation>Крен, Y from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy_3.toml" />
            <source>Accuracy, roll 0, 30, 60 deg</source>
            <translation>Точність, крен 0, 30, 60 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy_45.toml" />
            <source>Accuracy, roll 0 to 360 deg by 45</source>
            <translation>Точність, крен від 0 до 360 deg через 45</translation>
        </message>
        <message>
            <location filename="../../resources/plans/six_positions.toml" />
            <source>6 orthogonal positions</source>
            <translation>6 ортогональних положень</translation>
        </message>
        <message>
            <location filename="../../resources/plans/thermal_8.toml" />
            <source>8 positions at each temperature of the cycle</source>
            <translation>8 положень за кожної температури циклу</translation>
        </message>
    </context>
    <context>
        <name>SourceView</name>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Stop listening</source>
            <translation>Припинити</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Listen</source>
            <translation>Слухати</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Port</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>BaudRate</source>
            <translation>Швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Find speed</source>
            <translation>Знайти швидкість</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Listens at each baud rate until the bytes make sense; nothing is sent</source>
            <translation>Слухає на кожній швидкості, доки байти не набудуть сенсу; нічого не надсилається</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Raw log…</source>
            <translation>Журнал…</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Take the bytes of a raw log, a recording, or any file</source>
            <translation>Узяти байти з необробленого журналу, запису або будь-якого файла</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Find layout</source>
            <translation>Знайти будову</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Looks for frames, checksum and numbers in the latest bytes (F5)</source>
            <translation>Шукає кадри, контрольну суму і числа в останніх байтах (F5)</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Hold</source>
            <translation>Утримати</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Opens the port and only listens; nothing is sent</source>
            <translation>Відкриває порт і лише слухає; нічого не надсилається</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Raw bytes</source>
            <translation>Необроблені байти</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Raw logs and recordings (*.calrec)</source>
            <translation>Необроблені журнали і записи (*.calrec)</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
    </context>
    <context>
        <name>StripCharts</name>
        <message>
            <location filename="../../gui/widgets/strip_charts.py" />
            <source>Charts</source>
            <translation>Графіки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/strip_charts.py" />
            <source>Arrows move, plus and minus zoom, Home shows all, End tracks, A and B set cursors</source>
            <translation>Стрілки рухають, плюс і мінус масштабують, Home показує все, End стежить, A і B ставлять курсори</translation>
        </message>
    </context>
    <context>
        <name>ThermalView</name>
        <message>
            <location filename="../../gui/thermal/view.py" />
            <source>Positions and records (*.run.csv *.txt *.csv *.dat *.calrec session.json)</source>
            <translation>Положення і записи (*.run.csv *.txt *.csv *.dat *.calrec session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/view.py" />
            <source>All files (*)</source>
            <translation>Усі файли (*)</translation>
        </message>
    </context>
    <context>
        <name>ToolsView</name>
        <message>
            <location filename="../../gui/live/tools_view.py" />
            <source>Point on chart</source>
            <translation>Точок на графік</translation>
        </message>
        <message>
            <location filename="../../gui/live/tools_view.py" />
            <source>Decimation (table)</source>
            <translation>Проріджування (табл.)</translation>
        </message>
        <message>
            <location filename="../../gui/live/tools_view.py" />
            <source>Display only: the record is never decimated</source>
            <translation>Лише для показу: запис ніколи не проріджується</translation>
        </message>
    </context>
    <context>
        <name>TrialView</name>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Sealed by SHA-256: {seal}</source>
            <translation>Запечатано SHA-256: {seal}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Your answer: {names}</source>
            <translation>Ваша відповідь: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Look at the residuals against each regressor, tick what you think is hidden (nothing, one effect or two), and reveal.</source>
            <translation>Перегляньте залишки за кожним регресором, позначте, що, на вашу думку, приховано (нічого, один ефект чи два), і відкрийте.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Names to choose from</source>
            <translation>Назви на вибір</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Reveal</source>
            <translation>Відкрити</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Next Case</source>
            <translation>Наступний випадок</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>The next case is</source>
            <translation>Наступний випадок —</translation>
        </message>
    </context>
    <context>
        <name>TumbleSide</name>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Output</source>
            <translation>Вихід</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Which accelerometer; its axis must turn with the head.</source>
            <translation>Який акселерометр; його вісь має обертатися з головкою.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Harmonics</source>
            <translation>Гармоніки</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>The third shows a nonlinearity of third order.</source>
            <translation>Третя показує нелінійність третього порядку.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Local g</source>
            <translation>Місцеве g</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>1 where the readings are to be told per g.</source>
            <translation>1, якщо покази слід давати в g.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>u(g)</source>
            <translation>u(g)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Standard uncertainty, k = 1.</source>
            <translation>Стандартна невизначеність, k = 1.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>u(head)</source>
            <translation>u(головки)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Standard uncertainty of one setting of the head.</source>
            <translation>Стандартна невизначеність одного встановлення головки.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Fit a steady drift</source>
            <translation>Оцінити рівномірний дрейф</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Over the run, along with the series.</source>
            <translation>За серію, разом із рядом.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Signs of the paper</source>
            <translation>Знаки статті</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>k_x and k_y for the projection of gravity instead of specific force.</source>
            <translation>k_x і k_y для проекції сили тяжіння замість уявного прискорення.</translation>
        </message>
    </context>
    <context>
        <name>WindowMenu</name>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Go to</source>
            <translation>Перейти до</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Look</source>
            <translation>Вигляд</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Sounds</source>
            <translation>Звуки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Help</source>
            <translation>Довідка</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Distance view</source>
            <translation>Вигляд здалеку</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Preferences</source>
            <translation>Налаштування</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Keys</source>
            <translation>Клавіші</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Tour of the window</source>
            <translation>Огляд вікна</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Next tab</source>
            <translation>Наступна вкладка</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Tab before</source>
            <translation>Попередня вкладка</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Light</source>
            <translation>Світлий</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Dark</source>
            <translation>Темний</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>As the system</source>
            <translation>Як у системі</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Off</source>
            <translation>Вимкнено</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Quiet</source>
            <translation>Тихо</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Normal</source>
            <translation>Звичайно</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Loud</source>
            <translation>Голосно</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Language</source>
            <translation>Мова</translation>
        </message>
    </context>
    <context>
        <name>_Model</name>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Name</source>
            <translation>Назва</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Bytes</source>
            <translation>Байти</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Type</source>
            <translation>Тип</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Value</source>
            <translation>Значення</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Course</source>
            <translation>Хід</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Looks like</source>
            <translation>Схоже на</translation>
        </message>
    </context>
    <context>
        <name>_Next</name>
        <message>
            <location filename="../../gui/widgets/stage.py" />
            <source>Next</source>
            <translation>Далі</translation>
        </message>
    </context>
    <context>
        <name>_View</name>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Copy</source>
            <translation>Копіювати</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Copy as CSV (1.5, …)</source>
            <translation>Копіювати як CSV (1.5, …)</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Copy as CSV (1,5; …)</source>
            <translation>Копіювати як CSV (1,5; …)</translation>
        </message>
    </context>
</TS>
