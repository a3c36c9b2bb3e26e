<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
    <context>
        <name>AccuracyForm</name>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Angles</source>
            <translation>Углы</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>u(head angle), arcsec</source>
            <translation>u(угла головки), arcsec</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Limit ±, deg (0: none)</source>
            <translation>Предел ±, deg (0: нет)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Decision rule</source>
            <translation>Правило решения</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Own angles by the calibration</source>
            <translation>Собственные углы по калибровке</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Calibration</source>
            <translation>Калибровка</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Calibrations and positions (*.cal.json *.txt *.run.csv session.json)</source>
            <translation>Калибровки и положения (*.cal.json *.txt *.run.csv session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
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
            <translation>Тангаж или крен для задания, напр. 0, 30, 60; Enter принимает</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>with uncertainty: guard band U</source>
            <translation>защитная полоса U</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>simple acceptance</source>
            <translation>простая приёмка</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>nearest of this unit</source>
            <translation>ближайшая</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/settings_view.py" />
            <source>Choose</source>
            <translation>Выбрать</translation>
        </message>
    </context>
    <context>
        <name>AccuracyResultsView</name>
        <message>
            <location filename="../../gui/accuracy/results_view.py" />
            <source>Pages of the graph</source>
            <translation>Страницы графика</translation>
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
            <translation>Распознаёт покой в следующем положении и накапливает сам ({key})</translation>
        </message>
    </context>
    <context>
        <name>AdcPanel</name>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>{count} samples since Clear</source>
            <translation>отсчётов после очистки: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>calibrated by {name}</source>
            <translation>калибровано по {name}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>Clear</source>
            <translation>Очистить</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>Begin mean, STD, Min and Max anew</source>
            <translation>Начать среднее, СКО, мин. и макс. заново</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>Copy</source>
            <translation>Копировать</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc_view.py" />
            <source>ADC data of all channels</source>
            <translation>Данные АЦП всех каналов</translation>
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
            <translation>Гироскоп</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Dividing head</source>
            <translation>Делительная головка</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Rate table</source>
            <translation>Поворотный стол</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Climate chamber</source>
            <translation>Термокамера</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Level base</source>
            <translation>Горизонтальное основание</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Kind</source>
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Axis</source>
            <translation>Ось</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Case axis along which it looks.</source>
            <translation>Ось корпуса, вдоль которой он смотрит.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Accumulate</source>
            <translation>Накопление</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>At each position; 0 takes the time of the plan.</source>
            <translation>В каждом положении; 0 берёт время из плана.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Turning</source>
            <translation>Поворот</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Time that a change of the position takes.</source>
            <translation>Время, нужное на смену положения.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Local g</source>
            <translation>Местное g</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>u(g)</source>
            <translation>u(g)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Standard uncertainty, k = 1.</source>
            <translation>Стандартная неопределённость, k = 1.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>u(head)</source>
            <translation>u(головки)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Of one setting of the dividing head.</source>
            <translation>Одной установки делительной головки.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>u(table)</source>
            <translation>u(стола)</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Of one setting of the rate table.</source>
            <translation>Одной установки поворотного стола.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>North positive, south negative.</source>
            <translation>Северная положительна, южная отрицательна.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>as the plan</source>
            <translation>по плану</translation>
        </message>
    </context>
    <context>
        <name>AllanView</name>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Add Records</source>
            <translation>Добавить записи</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Records (*.calrec *.txt *.csv *.dat)</source>
            <translation>Записи (*.calrec *.txt *.csv *.dat)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Confidence</source>
            <translation>Довер. полоса</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Bands of one sigma, from the equivalent degrees of freedom</source>
            <translation>Полосы одной сигмы по эквивалентным степеням свободы</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Fitted terms</source>
            <translation>Оценённые составляющие</translation>
        </message>
        <message>
            <location filename="../../gui/allan/view.py" />
            <source>Terms of the chosen record with their slopes</source>
            <translation>Составляющие выбранной записи с их наклонами</translation>
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
            <translation>Импорт папки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Serial number, date, plan, operator, verdict … (Ctrl+F)</source>
            <translation>Заводской номер, дата, план, оператор, решение … (Ctrl+F)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Search the archive</source>
            <translation>Поиск в архиве</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Kind of entries</source>
            <translation>Вид записей</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Parameter that is followed</source>
            <translation>Параметр, за которым следят</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Temperature of what counts</source>
            <translation>Температура того, что считается</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Only calibrations at about this temperature count; the others are shown</source>
            <translation>Считаются только калибровки примерно при этой температуре; остальные показаны</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Entries</source>
            <translation>Записи архива</translation>
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
            <translation>Измерено</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Verdict</source>
            <translation>Решение</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Operator</source>
            <translation>Оператор</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>Plan or procedure</source>
            <translation>План или метод</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>all kinds</source>
            <translation>все виды</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>sessions</source>
            <translation>сеансы</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>calibrations</source>
            <translation>калибровки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>run files</source>
            <translation>файлы серий</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>old files</source>
            <translation>старые файлы</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>records</source>
            <translation>записи</translation>
        </message>
        <message>
            <location filename="../../gui/archive/view.py" />
            <source>means</source>
            <translation>средние</translation>
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
            <translation>Закрыть это сообщение</translation>
        </message>
    </context>
    <context>
        <name>BytesView</name>
        <message>
            <location filename="../../gui/frames/bytes_view.py" />
            <source>Choose the port of the board and its baud rate, and press Listen; or open a raw log. Frames, checksum and numbers are then looked for by themselves.</source>
            <translation>Выберите порт платы и его скорость и нажмите «Слушать»; или откройте необработанный журнал. Кадры, контрольная сумма и числа будут найдены сами.</translation>
        </message>
    </context>
    <context>
        <name>Callout</name>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>{number} of {count}</source>
            <translation>{number} из {count}</translation>
        </message>
        <message>
            <location filename="../../gui/tour/view.py" />
            <source>Leave the tour</source>
            <translation>Закончить обзор</translation>
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
            <translation>Далее</translation>
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
            <translation>Условия</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Results</source>
            <translation>Результаты</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Before adjustment</source>
            <translation>До регулировки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Remarks</source>
            <translation>Примечания</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Calibration certificate</source>
            <translation>Сертификат калибровки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Replaces certificate No. {number}, which holds no longer.</source>
            <translation>Заменяет сертификат № {number}, который больше не действует.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>CALIBRATION CERTIFICATE</source>
            <translation>СЕРТИФИКАТ КАЛИБРОВКИ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>No.</source>
            <translation>№</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Customer</source>
            <translation>Заказчик</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Item</source>
            <translation>Изделие</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Serial number</source>
            <translation>Заводской номер</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Condition of the item</source>
            <translation>Состояние изделия</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Received</source>
            <translation>Получено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Calibrated</source>
            <translation>Калибровано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Issued</source>
            <translation>Выдано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Place</source>
            <translation>Место</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>What was changed</source>
            <translation>Что изменено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The results relate only to the item calibrated.</source>
            <translation>Результаты относятся только к калиброванному изделию.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The certificate may be reproduced only in full.</source>
            <translation>Сертификат разрешено воспроизводить только полностью.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>End of the certificate</source>
            <translation>Конец сертификата</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Accreditation</source>
            <translation>Аккредитация</translation>
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
            <translation>Измерено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Records</source>
            <translation>Записи</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Software</source>
            <translation>Программа</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Air temperature</source>
            <translation>Температура воздуха</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Relative humidity</source>
            <translation>Относительная влажность</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Air pressure</source>
            <translation>Атмосферное давление</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Supply of the item</source>
            <translation>Питание изделия</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Temperature of the item</source>
            <translation>Температура изделия</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Local gravity g</source>
            <translation>Местное ускорение силы тяжести g</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standard uncertainty of a head setting</source>
            <translation>Стандартная неопределённость установки головки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standard uncertainty of a table rate</source>
            <translation>Стандартная неопределённость скорости стола</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standards used and their traceability</source>
            <translation>Применённые эталоны и их прослеживаемость</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Standard</source>
            <translation>Эталон</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Certificate</source>
            <translation>Сертификат</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Valid until</source>
            <translation>Действителен до</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Traceable to</source>
            <translation>Прослеживаемость до</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The positions leave no degree of freedom: no uncertainty can be stated.</source>
            <translation>Положения не оставляют степени свободы: неопределённость указать невозможно.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The stated intervals are two-sided, for a coverage probability of 95 %, from the profile of the likelihood; U is the larger of their two halves. Of what was not detected the one-sided limit is stated (&lt;), for the same probability.</source>
            <translation>Приведённые интервалы двусторонние, для вероятности охвата 95 %, по профилю правдоподобия; U - большая из двух их половин. Для того, что не обнаружено, приведён односторонний предел (&lt;) для той же вероятности.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The stated uncertainty is the expanded uncertainty U: the standard uncertainty times the coverage factor {span}, for a normal distribution and a coverage probability of 95 %.</source>
            <translation>Указанная неопределённость является расширенной неопределённостью U: стандартная неопределённость, умноженная на коэффициент охвата {span}, для нормального распределения и вероятности охвата 95 %.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>The stated uncertainty is the expanded uncertainty U: the standard uncertainty times the coverage factor {span}, Student's t for the effective degrees of freedom of each result, for a coverage probability of 95 %.</source>
            <translation>Указанная неопределённость является расширенной неопределённостью U: стандартная неопределённость, умноженная на коэффициент охвата {span}, t Стьюдента для эффективных степеней свободы каждого результата, для вероятности охвата 95 %.</translation>
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
            <translation>Решение</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Deviation</source>
            <translation>Отклонение</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>± U (95 %)</source>
            <translation>± U (95 %)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>± Limit</source>
            <translation>± предел</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Conformity</source>
            <translation>Соответствие</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Decision rule</source>
            <translation>Правило решения</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Statement of conformity</source>
            <translation>Заявление о соответствии</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>PASS</source>
            <translation>СООТВЕТСТВУЕТ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>FAIL</source>
            <translation>НЕ СООТВЕТСТВУЕТ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>UNDECIDED</source>
            <translation>НЕ РЕШЕНО</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/html.py" />
            <source>Authorised by</source>
            <translation>Утвердил</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>{title}, further columns</source>
            <translation>{title}, остальные столбцы</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Residuals by position</source>
            <translation>Остатки по положениям</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Remark</source>
            <translation>Замечание</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Warning</source>
            <translation>Предупреждение</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/parts.py" />
            <source>Error</source>
            <translation>Ошибка</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/pdf.py" />
            <source>Page {number} of {count}</source>
            <translation>Страница {number} из {count}</translation>
        </message>
    </context>
    <context>
        <name>CertificateTab</name>
        <message>
            <location filename="../../gui/certificate/limits.py" />
            <source>{text} is no number</source>
            <translation>{text} не является числом</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits.py" />
            <source>a limit must be above zero</source>
            <translation>предел должен быть больше нуля</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>No certificate can be made of these results</source>
            <translation>Из этих результатов сертификат не составить</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The certificate cannot be read</source>
            <translation>Сертификат невозможно прочитать</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>A withdrawal needs a reason</source>
            <translation>Для отзыва нужна причина</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>Missing: {list}.</source>
            <translation>Недостаёт: {list}.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The certificate is not complete</source>
            <translation>Сертификат неполон</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>What is issued gets its number for ever.</source>
            <translation>Выданный сертификат получает номер навсегда.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>Issue all the same</source>
            <translation>Выдать всё равно</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The laboratory's file is refused</source>
            <translation>Файл лаборатории отклонён</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The laboratory's file is not written</source>
            <translation>Файл лаборатории не записан</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>No. {number} is issued, its PDF is not written</source>
            <translation>№ {number} выдан, его PDF не записан</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>Write PDF and HTML does it once there is room.</source>
            <translation>«Записать PDF и HTML» сделает это, когда будет место.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>No. {number} is issued</source>
            <translation>№ {number} выдан</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>{name}, with HTML and JSON, in the folder certificates of the sessions.</source>
            <translation>{name}, с HTML и JSON, в папке certificates сеансов.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/presenter.py" />
            <source>The certificate could not be worked on</source>
            <translation>С сертификатом невозможно работать</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/scene.py" />
            <source>Process a calibration or a check in its tab and press Certificate on the page of its results; or load a session, a run file, an old file or a calibration here (Ctrl+O).</source>
            <translation>Обработайте калибровку или проверку в их вкладке и нажмите «Сертификат» на странице результатов; или загрузите здесь сеанс, файл серии, старый файл либо калибровку (Ctrl+O).</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/scene.py" />
            <source>There are no results yet</source>
            <translation>Результатов ещё нет</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/scene.py" />
            <source>Files are being read or written</source>
            <translation>Файлы читаются или записываются</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>name of the laboratory</source>
            <translation>название лаборатории</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>address of the laboratory</source>
            <translation>адрес лаборатории</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>person who authorises</source>
            <translation>утверждающее лицо</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>standards and their traceability</source>
            <translation>эталоны и их прослеживаемость</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>customer</source>
            <translation>заказчик</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>contact of the customer</source>
            <translation>контакт заказчика</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>item</source>
            <translation>изделие</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>serial number of the item</source>
            <translation>заводской номер изделия</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>condition of the item</source>
            <translation>состояние изделия</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>date of calibration</source>
            <translation>дата калибровки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>date of issue</source>
            <translation>дата выдачи</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>ambient temperature</source>
            <translation>температура окружающей среды</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>results</source>
            <translation>результаты</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>uncertainty of the results</source>
            <translation>неопределённость результатов</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>what was changed, and why</source>
            <translation>что изменено и почему</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>guard band U (JCGM 106)</source>
            <translation>защитная полоса U (JCGM 106)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>simple acceptance (ILAC-G8)</source>
            <translation>простая приёмка (ILAC-G8)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Residuals by position</source>
            <translation>Остатки по положениям</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Matrices {names}</source>
            <translation>Матрицы {names}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Process them again in their tab, then press Certificate there.</source>
            <translation>Обработайте их снова в их вкладке, затем нажмите там «Сертификат».</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Correct the place that is named, or move the file away and fill in the page Laboratory anew; until then nothing is written over it.</source>
            <translation>Исправьте названное место или перенесите файл и заполните страницу «Лаборатория» снова; до тех пор он ничем не будет перезаписан.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Its PDF and HTML still hold; take its JSON from a copy of the folder.</source>
            <translation>Его PDF и HTML ещё действуют; возьмите его JSON из копии папки.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Type why it holds no longer, then press Withdraw again.</source>
            <translation>Введите, почему он больше не действует, затем нажмите «Отозвать» снова.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Nothing was issued. Put right what is named, then do the same again.</source>
            <translation>Ничего не выдано. Исправьте названное, затем повторите.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>damaged</source>
            <translation>повреждён</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>withdrawn</source>
            <translation>отозван</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>replaced by {number}</source>
            <translation>заменён на {number}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>valid</source>
            <translation>действует</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Issue</source>
            <translation>Выдать</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Load Data</source>
            <translation>Загрузить данные</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Back to the draft</source>
            <translation>Назад к черновику</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Replace</source>
            <translation>Заменить</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>It was replaced or withdrawn before</source>
            <translation>Он уже заменён или отозван</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>Write PDF and HTML</source>
            <translation>Записать PDF и HTML</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/texts.py" />
            <source>They are there; nothing is overwritten</source>
            <translation>Они уже есть; ничего не перезаписывается</translation>
        </message>
    </context>
    <context>
        <name>CertificateView</name>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>No results yet</source>
            <translation>Результатов ещё нет</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>No. {number}, issued</source>
            <translation>№ {number}, выдан</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Draft No. {number}</source>
            <translation>Черновик № {number}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>ISO/IEC 17025 asks for: {list}</source>
            <translation>ISO/IEC 17025 требует: {list}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Results for a certificate</source>
            <translation>Результаты для сертификата</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Calibrations, sessions, runs (*.json *.jsonl *.csv *.txt)</source>
            <translation>Калибровки, сеансы, серии (*.json *.jsonl *.csv *.txt)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Order</source>
            <translation>Заказ</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Limits</source>
            <translation>Пределы</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Laboratory</source>
            <translation>Лаборатория</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Issued</source>
            <translation>Выдано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/view.py" />
            <source>Parts of the form</source>
            <translation>Части формы</translation>
        </message>
    </context>
    <context>
        <name>ChanceBar</name>
        <message>
            <location filename="../../gui/discrepancy/candidate_view.py" />
            <source>{chance} % to decide</source>
            <translation>{chance} % на решение</translation>
        </message>
    </context>
    <context>
        <name>ChartsView</name>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Full time scale</source>
            <translation>Всё время</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Auto tracking</source>
            <translation>Автослежение</translation>
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
            <translation>Наложить…</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>No overlay</source>
            <translation>Без наложения</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Select all</source>
            <translation>Выбрать всё</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Deselect all</source>
            <translation>Снять выбор</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Select interval</source>
            <translation>Выбрать интервал</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Show intervals</source>
            <translation>Показать интервалы</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Remove intervals</source>
            <translation>Убрать интервалы</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Means</source>
            <translation>Средние</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Mark</source>
            <translation>Отметка</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Freezes the picture; the record goes on</source>
            <translation>Останавливает картину; запись идёт</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Marks this moment in the record, with the note</source>
            <translation>Отмечает этот момент в записи вместе с примечанием</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Averages the selected intervals and writes means.dat beside the record</source>
            <translation>Усредняет выбранные интервалы и пишет means.dat рядом с записью</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Seconds of Auto tracking</source>
            <translation>Секунды автослежения</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>Note</source>
            <translation>Примечание</translation>
        </message>
        <message>
            <location filename="../../gui/live/charts_view.py" />
            <source>what happens now; Enter marks it</source>
            <translation>что происходит; Enter отмечает</translation>
        </message>
    </context>
    <context>
        <name>ComparisonSide</name>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Results and runs (*.json *.csv *.txt)</source>
            <translation>Результаты и серии (*.json *.csv *.txt)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Gyro</source>
            <translation>Гироскоп</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>File</source>
            <translation>Файл</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Gyros that are compared</source>
            <translation>Сравниваемые гироскопы</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Add files</source>
            <translation>Добавить файлы</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Remove</source>
            <translation>Убрать</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Local g, m/s²</source>
            <translation>Местное g, m/s²</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/side_view.py" />
            <source>Taken where a file states none</source>
            <translation>Берётся там, где файл его не указывает</translation>
        </message>
    </context>
    <context>
        <name>CompassContent</name>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>averaging time at each heading, s</source>
            <translation>время усреднения на каждом курсе, s</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>u of the heading, °</source>
            <translation>u курса, °</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>wanted, {target}°</source>
            <translation>желаемое, {target}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>as set, {u}°</source>
            <translation>как задано, {u}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>best, {u}°</source>
            <translation>лучшее, {u}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/content_view.py" />
            <source>State the noise of the gyro at the left, or take it from a record: then this curve shows how long to average.</source>
            <translation>Укажите слева шум гироскопа или возьмите его из записи: тогда эта кривая покажет, как долго усреднять.</translation>
        </message>
    </context>
    <context>
        <name>CompassSide</name>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Output</source>
            <translation>Выход</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Which gyro.</source>
            <translation>Какой гироскоп.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Headings</source>
            <translation>Курсы</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>To plan for; a run that is loaded brings its own.</source>
            <translation>Для планирования; загруженная серия имеет свои.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Latitude</source>
            <translation>Широта</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>North positive, south negative.</source>
            <translation>Северная положительна, южная отрицательна.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Scale factor</source>
            <translation>Масштаб. коэф.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Output for 1 °/s; 0 where the output is a rate.</source>
            <translation>Выход на 1 °/s; 0, если выход — скорость.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>u(tilt)</source>
            <translation>u(наклона)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Of one reading of the tilt, k = 1.</source>
            <translation>Одного показания наклона, k = 1.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Average</source>
            <translation>Усреднение</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>At each heading.</source>
            <translation>На каждом курсе.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Turning</source>
            <translation>Поворот</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Time to turn and settle before each heading.</source>
            <translation>Время на поворот и успокоение перед каждым курсом.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Wanted u</source>
            <translation>Желаемое u</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Standard uncertainty of the heading; 0 for none.</source>
            <translation>Стандартная неопределённость курса; 0 — нет.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>not stated</source>
            <translation>не указано</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>The drift changes steadily</source>
            <translation>Дрейф равномерно меняется</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/side_view.py" />
            <source>Estimate its change; needs times and five readings.</source>
            <translation>Оценить его изменение; нужны времена и пять показаний.</translation>
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
            <translation>Курс: ещё не измерен</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/compass_view.py" />
            <source>Heading {value}° ± {half}°</source>
            <translation>Курс {value}° ± {half}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/compass_view.py" />
            <source>wedge: 95 %, drawn {count} times as wide</source>
            <translation>клин: 95 %, нарисован в {count} раз шире</translation>
        </message>
    </context>
    <context>
        <name>DefinitionView</name>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Both meanings are shown; the stream says which one fits.</source>
            <translation>Показаны оба значения; поток говорит, какое подходит.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Header</source>
            <translation>Заголовок</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Length</source>
            <translation>Длина</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Checksum</source>
            <translation>Контр. сумма</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Device name</source>
            <translation>Имя устройства</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Kind</source>
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source> bytes</source>
            <translation> байтов</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Save device file</source>
            <translation>Сохранить файл устройства</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Save and connect</source>
            <translation>Сохранить и подключить</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>what the operators call the board</source>
            <translation>как операторы называют плату</translation>
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
            <translation>не подключено</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>opening</source>
            <translation>открывается</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>streaming</source>
            <translation>передаёт</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>open, no data</source>
            <translation>открыто, данных нет</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>link lost</source>
            <translation>связь потеряна</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Properties</source>
            <translation>Свойства</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Device Properties: number, port, baud rate, scan</source>
            <translation>Свойства устройств: число, порт, скорость, поиск</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Device</source>
            <translation>Устройство</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>View ADC Data, Stop Device</source>
            <translation>Данные АЦП, остановка устройства</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Temperature of the device</source>
            <translation>Температура устройства</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>frames</source>
            <translation>кадры</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Frames received with a right checksum</source>
            <translation>Получено кадров с верной контрольной суммой</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>bytes</source>
            <translation>байты</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Bytes received</source>
            <translation>Получено байтов</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>bad</source>
            <translation>плохие</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Frames with a wrong checksum</source>
            <translation>Кадры с неверной контрольной суммой</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>lost</source>
            <translation>потеряно</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Samples sent by the device that never came</source>
            <translation>Отсчёты, переданные устройством, которые не дошли</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>garbage</source>
            <translation>мусор</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/device_strip.py" />
            <source>Bytes that belong to no frame</source>
            <translation>Байты, не принадлежащие ни одному кадру</translation>
        </message>
    </context>
    <context>
        <name>DevicesView</name>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device Properties</source>
            <translation>Свойства устройств</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Number of Devices</source>
            <translation>Число устройств</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device name</source>
            <translation>Имя устройства</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Port Name</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>BaudRate</source>
            <translation>Скорость</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device file</source>
            <translation>Файл устройства</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Scan</source>
            <translation>Поиск</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Listens at every baud rate; nothing is sent</source>
            <translation>Слушает на каждой скорости; ничего не передаёт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Refresh ports</source>
            <translation>Обновить порты</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Stop scanning</source>
            <translation>Остановить поиск</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>OK</source>
            <translation>OK</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Ask for names</source>
            <translation>Запросить имена</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Do not ask</source>
            <translation>Не запрашивать</translation>
        </message>
    </context>
    <context>
        <name>Dial</name>
        <message>
            <location filename="../../gui/rig/dial_view.py" />
            <source>Dividing head</source>
            <translation>Делительная головка</translation>
        </message>
    </context>
    <context>
        <name>DiscrepancyView</name>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>Load Data</source>
            <translation>Загрузить данные</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>Measurements (*.run.csv *.txt session.json)</source>
            <translation>Измерения (*.run.csv *.txt session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/view.py" />
            <source>Where the residual has structure</source>
            <translation>Где остаток имеет структуру</translation>
        </message>
    </context>
    <context>
        <name>DistanceView</name>
        <message>
            <location filename="../../gui/widgets/distance_view.py" />
            <source>Next: {step}</source>
            <translation>Далее: {step}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/distance_view.py" />
            <source>Esc leaves</source>
            <translation>Esc — выход</translation>
        </message>
    </context>
    <context>
        <name>DriftView</name>
        <message>
            <location filename="../../gui/drift/view.py" />
            <source>Turn-ons (*.calrec *.run.csv *.txt *.csv *.dat)</source>
            <translation>Включения (*.calrec *.run.csv *.txt *.csv *.dat)</translation>
        </message>
        <message>
            <location filename="../../gui/drift/view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
    </context>
    <context>
        <name>ErrorGraph</name>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>set angle, deg</source>
            <translation>заданный угол, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>{title}; limit ±{limit} lies outside</source>
            <translation>{title}; предел ±{limit} лежит за полем</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>limit ±{limit}°</source>
            <translation>предел ±{limit}°</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/graph_view.py" />
            <source>now {value}°</source>
            <translation>сейчас {value}°</translation>
        </message>
    </context>
    <context>
        <name>ExportFoot</name>
        <message>
            <location filename="../../gui/widgets/export_foot.py" />
            <source>Export format</source>
            <translation>Формат экспорта</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/export_foot.py" />
            <source>File of the export</source>
            <translation>Файл экспорта</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/export_foot.py" />
            <source>Export</source>
            <translation>Экспорт</translation>
        </message>
    </context>
    <context>
        <name>FieldForm</name>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Name</source>
            <translation>Имя</translation>
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
            <translation>Сдвиг</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Role</source>
            <translation>Роль</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>little endian</source>
            <translation>младший байт первый</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>big endian</source>
            <translation>старший байт первый</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Byte order</source>
            <translation>Порядок байтов</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>A number or an expression, such as 20*9.80665/65536</source>
            <translation>Число или выражение, например 20*9.80665/65536</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Tells the program what it measures: acc in m/s^2, rate in deg/s, temp in degC</source>
            <translation>Говорит программе, что измеряется: acc в m/s^2, rate в deg/s, temp в degC</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>No channel</source>
            <translation>Не канал</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Add field</source>
            <translation>Добавить поле</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Makes numbers of the bytes pointed at (Enter)</source>
            <translation>Делает числа из отмеченных байтов (Enter)</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Remove field</source>
            <translation>Убрать поле</translation>
        </message>
        <message>
            <location filename="../../gui/frames/field_form_view.py" />
            <source>Takes away the fields on the bytes pointed at (Delete)</source>
            <translation>Убирает поля на отмеченных байтах (Delete)</translation>
        </message>
    </context>
    <context>
        <name>FindingsView</name>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Nothing is undecided: no further measurement is proposed.</source>
            <translation>Ничего не осталось нерешённым: дальнейших измерений не предлагается.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>No series that was tried is likely to tell these names apart.</source>
            <translation>Ни одна из проверенных серий вряд ли различит эти названия.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Keep this plan</source>
            <translation>Сохранить этот план</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Open this plan</source>
            <translation>Открыть этот план</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>From which size on these rows name an effect</source>
            <translation>С какой величины эти строки называют эффект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Candidates</source>
            <translation>Кандидаты</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Measure next</source>
            <translation>Измерить далее</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>What can be seen</source>
            <translation>Что можно увидеть</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Measure next ({count})</source>
            <translation>Измерить далее ({count})</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/findings_view.py" />
            <source>Practice</source>
            <translation>Тренировка</translation>
        </message>
    </context>
    <context>
        <name>FramesView</name>
        <message>
            <location filename="../../gui/frames/view.py" />
            <source>Bytes of the stream, one frame a row</source>
            <translation>Байты потока, по кадру в строке</translation>
        </message>
        <message>
            <location filename="../../gui/frames/view.py" />
            <source>Numbers of the board</source>
            <translation>Числа платы</translation>
        </message>
    </context>
    <context>
        <name>GapBar</name>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>gap {gap}</source>
            <translation>расхождение {gap}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Gap {gap} noise floors; rows left out of the fit: {held}</source>
            <translation>Расхождение {gap} уровней шума; строки, исключённые из оценки: {held}</translation>
        </message>
    </context>
    <context>
        <name>HarmonicsView</name>
        <message>
            <location filename="../../gui/tumble/harmonics_view.py" />
            <source>Harmonics</source>
            <translation>Гармоники</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/harmonics_view.py" />
            <source>|C|, {unit}; dashes: what noise alone exceeds in 1 % of cases</source>
            <translation>|C|, {unit}; штрихи: что один шум превышает в 1 % случаев</translation>
        </message>
    </context>
    <context>
        <name>HeadForm</name>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>u(head angle), arcsec</source>
            <translation>u(угла головки), arcsec</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Base orientation</source>
            <translation>Ориентация основания</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Tilter</source>
            <translation>Наклонитель</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Tilter No.</source>
            <translation>Наклонитель №</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Position</source>
            <translation>Положение</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Free angle</source>
            <translation>Свободный угол</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>None</source>
            <translation>Нет</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Auto</source>
            <translation>Авто</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Manual</source>
            <translation>Вручную</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Add</source>
            <translation>Добавить</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Mount of the free angle</source>
            <translation>Установка для свободного угла</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Free angle, deg</source>
            <translation>Свободный угол, deg</translation>
        </message>
    </context>
    <context>
        <name>HistoryPlot</name>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>mean ± s</source>
            <translation>среднее ± s</translation>
        </message>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>limits</source>
            <translation>пределы</translation>
        </message>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>value ± U</source>
            <translation>значение ± U</translation>
        </message>
        <message>
            <location filename="../../gui/archive/history_view.py" />
            <source>not counted</source>
            <translation>не учтено</translation>
        </message>
    </context>
    <context>
        <name>KeysView</name>
        <message>
            <location filename="../../gui/keys/view.py" />
            <source>Find a key or what it does</source>
            <translation>Найти клавишу или её действие</translation>
        </message>
        <message>
            <location filename="../../gui/keys/view.py" />
            <source>Save as PDF</source>
            <translation>Сохранить как PDF</translation>
        </message>
        <message>
            <location filename="../../gui/keys/view.py" />
            <source>Close</source>
            <translation>Закрыть</translation>
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
            <translation>Хранится в laboratory.json в папке сеансов, для всех сертификатов.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Laboratory</source>
            <translation>Лаборатория</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Address</source>
            <translation>Адрес</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Place</source>
            <translation>Место</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Accreditation</source>
            <translation>Аккредитация</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Logo</source>
            <translation>Логотип</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Authorised by</source>
            <translation>Утвердил</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Position</source>
            <translation>Должность</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Number</source>
            <translation>Номер</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Further text</source>
            <translation>Дополнительный текст</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>of calibration, if it is another one</source>
            <translation>калибровки, если другое</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>number and body, if any</source>
            <translation>номер и орган, если есть</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>picture, PNG, JPEG or SVG</source>
            <translation>рисунок, PNG, JPEG или SVG</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>at the end of every certificate</source>
            <translation>в конце каждого сертификата</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>{year} and {n} are replaced; {n:04d} is the number with four digits</source>
            <translation>{year} и {n} заменяются; {n:04d} — номер из четырёх цифр</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Choose logo</source>
            <translation>Выбрать логотип</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Standards</source>
            <translation>Эталоны</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Add</source>
            <translation>Добавить</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Remove</source>
            <translation>Убрать</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Standards and their traceability</source>
            <translation>Эталоны и их прослеживаемость</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Standard</source>
            <translation>Эталон</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Serial no.</source>
            <translation>Зав. №</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Certificate</source>
            <translation>Сертификат</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Valid until</source>
            <translation>Действителен до</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/laboratory_view.py" />
            <source>Traceable to</source>
            <translation>Прослеживаемость до</translation>
        </message>
    </context>
    <context>
        <name>LadderView</name>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>The ladder</source>
            <translation>Лестница</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Bars: gap in noise floors (dotted: the floor, 1). Stroke: rows left out.</source>
            <translation>Полосы: расхождение в уровнях шума (пунктир: уровень, 1). Черта: исключённые строки.</translation>
        </message>
    </context>
    <context>
        <name>LimitsForm</name>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Conformity: {verdict}</source>
            <translation>Соответствие: {verdict}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>A parameter with a limit is judged: its deviation from the nominal value, 0 if none is given, in all sensors that have it. A check brings its verdict with it.</source>
            <translation>Параметр с пределом оценивается: его отклонение от номинального значения (0, если не задано) во всех датчиках, у которых он есть. Проверка приносит своё решение с собой.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Decision rule</source>
            <translation>Правило решения</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Printed</source>
            <translation>Печатается</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Limits of the parameters</source>
            <translation>Пределы параметров</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Parts of the results that are printed</source>
            <translation>Печатаемые части результатов</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Parameter</source>
            <translation>Параметр</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Nominal</source>
            <translation>Номинал</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>± Limit</source>
            <translation>± предел</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/limits_view.py" />
            <source>Found</source>
            <translation>Найдено</translation>
        </message>
    </context>
    <context>
        <name>LiveTable</name>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Accelerations</source>
            <translation>Ускорения</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Angular Rates</source>
            <translation>Угл. скорости</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>Mean ({unit})</source>
            <translation>Среднее ({unit})</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/live_view.py" />
            <source>STD ({unit})</source>
            <translation>СКО ({unit})</translation>
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
            <translation>Пакетов: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>lost {n}</source>
            <translation>потеряно {n}</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>on disk {mb} MB</source>
            <translation>на диске {mb} MB</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>disk lasts {time}</source>
            <translation>диска хватит на {time}</translation>
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
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Charts</source>
            <translation>Графики</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Table</source>
            <translation>Таблица</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Means</source>
            <translation>Средние</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Save</source>
            <translation>Сохранить</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Format</source>
            <translation>Формат</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>File to save</source>
            <translation>Файл для сохранения</translation>
        </message>
        <message>
            <location filename="../../gui/live/view.py" />
            <source>Status</source>
            <translation>Состояние</translation>
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
            <translation>Показать или скрыть журнал (Ctrl+L)</translation>
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
            <translation>Вид, звуки, клавиши, настройки (F10)</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Simulated rig</source>
            <translation>Симулированный стенд</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>View ADC Data</source>
            <translation>Данные АЦП</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Stop Device</source>
            <translation>Остановить устройство</translation>
        </message>
        <message>
            <location filename="../../gui/main_window.py" />
            <source>Start Device</source>
            <translation>Запустить устройство</translation>
        </message>
    </context>
    <context>
        <name>MeansView</name>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Means of the selection</source>
            <translation>Средние выбранного</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Of the selected intervals, else from A to B, else of everything on the charts</source>
            <translation>По выбранным интервалам, иначе от A до B, иначе по всему на графиках</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Means of a folder…</source>
            <translation>Средние папки…</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Mean ± its standard error, which respects correlated noise. Enter what was set for each record, or paste a column of it; the run file then goes into the fit.</source>
            <translation>Среднее ± его стандартная погрешность с учётом коррелированного шума. Введите, что было задано для каждой записи, или вставьте столбец; тогда файл серии идёт на оценку.</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>For the fit of the</source>
            <translation>Для оценки</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>rate table: set rate, °/s</source>
            <translation>поворотный стол: заданная скорость, °/s</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>dividing head: X_from:90</source>
            <translation>делительная головка: X_from:90</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Run file</source>
            <translation>Файл серии</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Write run file</source>
            <translation>Записать файл серии</translation>
        </message>
        <message>
            <location filename="../../gui/live/means_view.py" />
            <source>Means</source>
            <translation>Средние</translation>
        </message>
    </context>
    <context>
        <name>MeasuringView</name>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Folder of the session; can be changed</source>
            <translation>Папка сеанса; можно изменить</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Load Data</source>
            <translation>Загрузить данные</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Measurements (*.txt *.run.csv session.json)</source>
            <translation>Измерения (*.txt *.run.csv session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Plan</source>
            <translation>План</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>What can this plan show?</source>
            <translation>Что может показать этот план?</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Session</source>
            <translation>Сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Name of the session's folder</source>
            <translation>Имя папки сеанса</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>New session</source>
            <translation>Новый сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>Main Graph</source>
            <translation>Главный график</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/view.py" />
            <source>The graph begins when samples come.</source>
            <translation>График начнётся, когда придут отсчёты.</translation>
        </message>
    </context>
    <context>
        <name>MethodsView</name>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Which procedure?</source>
            <translation>Какой метод?</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Fourier tumble</source>
            <translation>Оборот по Фурье</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Gyrocompass</source>
            <translation>Гирокомпас</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Compare gyros</source>
            <translation>Сравнение гироскопов</translation>
        </message>
        <message>
            <location filename="../../gui/methods/view.py" />
            <source>Methods</source>
            <translation>Методы</translation>
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
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>White noise N</source>
            <translation>Белый шум N</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Two-sided density, as the Allan tab tells it.</source>
            <translation>Двусторонняя плотность, как её показывает вкладка Аллана.</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Flicker B</source>
            <translation>Фликкер B</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Floor of the Allan curve over 0.664.</source>
            <translation>Дно кривой Аллана, делённое на 0,664.</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Walk K</source>
            <translation>Блуждание K</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Random walk of the rate or of the acceleration.</source>
            <translation>Случайное блуждание скорости или ускорения.</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Noise from a record …</source>
            <translation>Шум из записи …</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/noise_fields.py" />
            <source>Analyse a record of the sensor at rest, as the Allan tab</source>
            <translation>Анализирует запись датчика в покое, как вкладка Аллана</translation>
        </message>
    </context>
    <context>
        <name>OrderForm</name>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>year-month-day</source>
            <translation>год-месяц-день</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Surroundings</source>
            <translation>Окружающая среда</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Customer</source>
            <translation>Заказчик</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Contact</source>
            <translation>Контакт</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Item</source>
            <translation>Изделие</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Type</source>
            <translation>Тип</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Serial number</source>
            <translation>Заводской номер</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Condition</source>
            <translation>Состояние</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Received</source>
            <translation>Получено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Calibrated</source>
            <translation>Калибровано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Issued</source>
            <translation>Выдано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Before adjustment</source>
            <translation>До регулировки</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Remarks</source>
            <translation>Примечания</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Replaces No.</source>
            <translation>Заменяет №</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>What was changed</source>
            <translation>Что изменено</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>name and address</source>
            <translation>название и адрес</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>e.g. inclinometer, triad of accelerometers</source>
            <translation>напр. инклинометр, триада акселерометров</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>e.g. without visible damage</source>
            <translation>напр. без видимых повреждений</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>what was found, or that nothing was adjusted</source>
            <translation>что обнаружено, или что ничего не регулировали</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>deviations from the method, opinions</source>
            <translation>отклонения от методики, мнения</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>and why</source>
            <translation>и почему</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Air temperature, °C</source>
            <translation>Температура воздуха, °C</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Relative humidity, %</source>
            <translation>Относительная влажность, %</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Air pressure, hPa</source>
            <translation>Атмосферное давление, hPa</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/order_view.py" />
            <source>Supply of the item, V</source>
            <translation>Питание изделия, V</translation>
        </message>
    </context>
    <context>
        <name>OverviewView</name>
        <message>
            <location filename="../../gui/discrepancy/overview_view.py" />
            <source>times the noise floor; 1 is the best</source>
            <translation>уровней шума; лучше всего — 1</translation>
        </message>
    </context>
    <context>
        <name>PlanView</name>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>What this rig can do, the best first</source>
            <translation>Что может этот стенд, лучшее — первым</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Steps: tick off what you would leave out</source>
            <translation>Шаги: снимите отметку с лишних</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Plans</source>
            <translation>Планы</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Steps</source>
            <translation>Шаги</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Mount of the step to add</source>
            <translation>Установка добавляемого шага</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Angle or rate of the step to add</source>
            <translation>Угол или скорость добавляемого шага</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/plan_view.py" />
            <source>Add step</source>
            <translation>Добавить шаг</translation>
        </message>
    </context>
    <context>
        <name>PlotsView</name>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>output, {unit}</source>
            <translation>выход, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated, plain model</source>
            <translation>симуляция, простая модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated, with the effects</source>
            <translation>симуляция, с эффектами</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>measured</source>
            <translation>измерено</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated rig</source>
            <translation>имитированный стенд</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>residual</source>
            <translation>остаток</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>structure</source>
            <translation>структура</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>95 % band for all points</source>
            <translation>полоса 95 % для всех точек</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>simulated rig less model</source>
            <translation>имитированный стенд минус модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>Output</source>
            <translation>Выход</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>With the effects added</source>
            <translation>С добавленными эффектами</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>this table</source>
            <translation>эта таблица</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>left, {unit}</source>
            <translation>остаток, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Snap to blocks</source>
            <translation>Привязка к блокам</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Drag a knot with the mouse; or choose it by Page Up and Page Down and move it by the arrow keys.</source>
            <translation>Перетащите узел мышью или выберите его клавишами Page Up и Page Down и двигайте стрелками.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Temperature</source>
            <translation>Температура</translation>
        </message>
        <message>
            <location filename="../../gui/drift/plots_view.py" />
            <source>Left on turn-ons that were not seen, rms</source>
            <translation>Остаётся на не виденных включениях, СКО</translation>
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
            <translation>Остатки по углу возвышения</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/polar_view.py" />
            <source>largest residual {value} {unit}</source>
            <translation>наибольший остаток {value} {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/polar_view.py" />
            <source>Residuals, {unit}; out is positive, shade: ±U (95 %)</source>
            <translation>Остатки, {unit}; наружу — положительные, тень: ±U (95 %)</translation>
        </message>
    </context>
    <context>
        <name>PositionPicture</name>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>from the head</source>
            <translation>от головки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>to the head</source>
            <translation>к головке</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>up</source>
            <translation>вверх</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>down</source>
            <translation>вниз</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>right</source>
            <translation>вправо</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/position_picture.py" />
            <source>left</source>
            <translation>влево</translation>
        </message>
    </context>
    <context>
        <name>PreferencesView</name>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Sessions go there from the next start on; nothing is moved.</source>
            <translation>Сеансы идут туда со следующего запуска; ничего не переносится.</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Gravity and latitude are taken by every tab that is not in the middle of a session; a tab may still state its own.</source>
            <translation>Ускорение силы тяжести и широту берёт каждая вкладка, которая не посреди сеанса; вкладка может указать свои.</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Folder of sessions</source>
            <translation>Папка сеансов</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Preferences</source>
            <translation>Настройки</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Operator</source>
            <translation>Оператор</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Local g</source>
            <translation>Местное g</translation>
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
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Sounds</source>
            <translation>Звуки</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Language</source>
            <translation>Язык</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>stated in every session</source>
            <translation>указывается в каждом сеансе</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>not stated</source>
            <translation>не указано</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Browse</source>
            <translation>Обзор…</translation>
        </message>
        <message>
            <location filename="../../gui/preferences/view.py" />
            <source>Close</source>
            <translation>Закрыть</translation>
        </message>
    </context>
    <context>
        <name>PreviewView</name>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Page {number} of {count}</source>
            <translation>Страница {number} из {count}</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Fit width</source>
            <translation>По ширине</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Whole page</source>
            <translation>Вся страница</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Size of the page</source>
            <translation>Размер страницы</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Page before (Page Up)</source>
            <translation>Предыдущая страница (Page Up)</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/preview_view.py" />
            <source>Page after (Page Down)</source>
            <translation>Следующая страница (Page Down)</translation>
        </message>
    </context>
    <context>
        <name>ProposalView</name>
        <message>
            <location filename="../../gui/discrepancy/candidate_view.py" />
            <source>Less likely</source>
            <translation>Менее вероятные</translation>
        </message>
    </context>
    <context>
        <name>RateForm</name>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>u(rate), deg/s</source>
            <translation>u(скорости), deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>u(rate), ppm</source>
            <translation>u(скорости), ppm</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>u(head angle), arcsec</source>
            <translation>u(угла головки), arcsec</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Full scale, deg/s</source>
            <translation>Полная шкала, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Latitude, deg</source>
            <translation>Широта, deg</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Rates of your own, deg/s</source>
            <translation>Собственные скорости, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Axis</source>
            <translation>Ось</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Whole turns of the table</source>
            <translation>Целые обороты стола</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>Each accumulation is made as long as whole turns nearest to the time above</source>
            <translation>Каждое накопление длится столько целых оборотов, чтобы быть ближайшим ко времени вверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>largest</source>
            <translation>макс.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/settings_view.py" />
            <source>not stated</source>
            <translation>не задана</translation>
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
            <translation>Вверх и вниз</translation>
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
            <translation>Выберите один, чтобы увидеть его. Выданный сертификат не меняется: «Заменить» начинает новый, называющий его, «Отозвать» свидетельствует, что он больше не действует.</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>No.</source>
            <translation>№</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>State</source>
            <translation>Статус</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Serial no.</source>
            <translation>Зав. №</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Issued</source>
            <translation>Выдано</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Verdict</source>
            <translation>Решение</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Item</source>
            <translation>Изделие</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Customer</source>
            <translation>Заказчик</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Issued certificates</source>
            <translation>Выданные сертификаты</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Reason</source>
            <translation>Причина</translation>
        </message>
        <message>
            <location filename="../../gui/certificate/register_view.py" />
            <source>Withdraw</source>
            <translation>Отозвать</translation>
        </message>
    </context>
    <context>
        <name>ResidualPlot</name>
        <message>
            <location filename="../../gui/widgets/residual_plot.py" />
            <source>Residuals by position</source>
            <translation>Остатки по положениям</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/residual_plot.py" />
            <source>residual, {unit}; band: ±U (95 %)</source>
            <translation>остаток, {unit}; полоса: ±U (95 %)</translation>
        </message>
    </context>
    <context>
        <name>ResultTable</name>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Table of results</source>
            <translation>Таблица результатов</translation>
        </message>
    </context>
    <context>
        <name>ResultsView</name>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>With: {effects}</source>
            <translation>С эффектами: {effects}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Certificate</source>
            <translation>Сертификат</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Make a calibration certificate of these results</source>
            <translation>Составить сертификат калибровки из этих результатов</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Close the results</source>
            <translation>Закрыть результаты</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Model vs data</source>
            <translation>Модель и данные</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Compare the model with the rows: find out what it lacks</source>
            <translation>Сравнить модель со строками: выяснить, чего ей недостаёт</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Take Out</source>
            <translation>Убрать</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results_view.py" />
            <source>Calibrate by the plain model again</source>
            <translation>Калибровать снова по простой модели</translation>
        </message>
    </context>
    <context>
        <name>RigPanel</name>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>moving</source>
            <translation>движется</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>at rest</source>
            <translation>в покое</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>table: {rate} deg/s about {axis}</source>
            <translation>стол: {rate} deg/s вокруг {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Unplug</source>
            <translation>Отключить</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Plug in</source>
            <translation>Подключить</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Operator turns it for me</source>
            <translation>Поворачивает оператор</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Angle</source>
            <translation>Угол</translation>
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
            <translation>Стол</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Angle of the head</source>
            <translation>Угол головки</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Turn</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Somebody sets every position that the test asks for</source>
            <translation>Кто-то устанавливает каждое положение, которого просит испытание</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Faults</source>
            <translation>Неисправности</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Noise burst</source>
            <translation>Всплеск</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Noisy line</source>
            <translation>Помехи</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Lost frames</source>
            <translation>Без кадров</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>Stuck channel</source>
            <translation>Зависание</translation>
        </message>
    </context>
    <context>
        <name>RowsPlot</name>
        <message>
            <location filename="../../gui/discrepancy/plots_view.py" />
            <source>measured − simulated, {unit}</source>
            <translation>измеренное − симулированное, {unit}</translation>
        </message>
    </context>
    <context>
        <name>RungView</name>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>proposed</source>
            <translation>предложение</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Take it back, with all above it</source>
            <translation>Убрать его вместе со всеми выше</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_view.py" />
            <source>Take back {title}</source>
            <translation>Убрать {title}</translation>
        </message>
    </context>
    <context>
        <name>SampleTable</name>
        <message>
            <location filename="../../gui/live/table_view.py" />
            <source>Table of samples</source>
            <translation>Таблица отсчётов</translation>
        </message>
    </context>
    <context>
        <name>SettingsForm</name>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Accumulation Time, sec</source>
            <translation>Время накопления, s</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Settling time, sec</source>
            <translation>Время успокоения, s</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Passes</source>
            <translation>Проходы</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Local g, m/s²</source>
            <translation>Местное g, m/s²</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>u(g), m/s²</source>
            <translation>u(g), m/s²</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Temperatures of the cycle, °C</source>
            <translation>Температуры цикла, °C</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Temperatures, °C</source>
            <translation>Температуры, °C</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Termo calibration</source>
            <translation>Термокалибровка</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/settings_view.py" />
            <source>Settings</source>
            <translation>Настройки</translation>
        </message>
    </context>
    <context>
        <name>SettingsView</name>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>state it</source>
            <translation>укажите</translation>
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
            <translation>Отсчётов в секунду; 0 берёт частоту из файла.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Scale factor</source>
            <translation>Масштаб. коэф.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Output for 1 °/s (1 m/s²); the samples are divided by it.</source>
            <translation>Выход на 1 °/s (1 m/s²); отсчёты делятся на него.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Of the samples, after the scale factor.</source>
            <translation>Отсчётов, после масштабного коэффициента.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Bandwidth</source>
            <translation>Полоса</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Of the sensor. A filter within the band falsifies N and B most.</source>
            <translation>Датчика. Фильтр внутри полосы сильнее всего искажает N и B.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Regress on</source>
            <translation>Регрессия</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Show the curve before and after taking off what this channel explains.</source>
            <translation>Показать кривую до и после исключения того, что объясняет этот канал.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Order</source>
            <translation>Порядок</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Highest power of that channel.</source>
            <translation>Наивысшая степень этого канала.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Beside</source>
            <translation>Рядом</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Another deviation beside Allan's; needs the package AllanTools.</source>
            <translation>Другая девиация рядом с аллановской; нужен пакет AllanTools.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>nothing</source>
            <translation>ничего</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Hadamard</source>
            <translation>Адамара</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>modified</source>
            <translation>модифицированная</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>total</source>
            <translation>полная</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>found</source>
            <translation>авто</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>Angle increments (fit Q)</source>
            <translation>Приращения угла (оценить Q)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>The device sends increments of angle; a rate output has no quantisation Q.</source>
            <translation>Устройство передаёт приращения угла; у выхода скорости нет квантования Q.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Chamber</source>
            <translation>Камера</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Of the chosen record; the same number for all turn-ons of one set.</source>
            <translation>Выбранной записи; одинаковое число для всех включений одного набора.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Start from</source>
            <translation>Начало от</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>The mean over this time is brought to zero, here and in use.</source>
            <translation>Среднее за это время сводится к нулю, здесь и в работе.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Start to</source>
            <translation>Начало до</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>The compensation works from here on.</source>
            <translation>Компенсация действует отсюда.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Block</source>
            <translation>Блок</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Means over this time; long against noise, short against a bend.</source>
            <translation>Средние за это время; длинно для шума, коротко для изгиба.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Horizon</source>
            <translation>Горизонт</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>How long the compensation shall work.</source>
            <translation>Как долго должна действовать компенсация.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Most knots tp</source>
            <translation>Узлов до</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>What the microcontroller has room for.</source>
            <translation>На что хватает места в микроконтроллере.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Memory</source>
            <translation>Память</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Of times, temperatures and values, 2 bytes each.</source>
            <translation>Для времён, температур и значений, по 2 байта.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Knots</source>
            <translation>Узлы</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>By held-out turn-ons: the fewest that leave at most 2 % more.</source>
            <translation>По исключённым включениям: наименьшее, которое оставляет не более чем на 2 % больше.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Output</source>
            <translation>Выход</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Name or number of the channel.</source>
            <translation>Имя или номер канала.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Samples per second, where the file does not tell it.</source>
            <translation>Отсчётов в секунду, если файл этого не сообщает.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>Output for 1 °/s.</source>
            <translation>Выход на 1 °/s.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>by the chip</source>
            <translation>кристалл</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>whole record</source>
            <translation>вся</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>by tp alone</source>
            <translation>по tp</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>of the file</source>
            <translation>из файла</translation>
        </message>
        <message>
            <location filename="../../gui/drift/settings_view.py" />
            <source>likeliest</source>
            <translation>авто</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>none: see Properties above</source>
            <translation>нет: см. «Свойства» вверху</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Device and Port Settings</source>
            <translation>Настройки устройства и порта</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Port</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Device #</source>
            <translation>Устройство №</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Test</source>
            <translation>Испытание</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Profile #</source>
            <translation>Профиль №</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Sampling frequency</source>
            <translation>Дискретизация</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>as the device calls itself</source>
            <translation>как называет себя устройство</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Static</source>
            <translation>Статическое</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Dynamic</source>
            <translation>Динамическое</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Rows a second of CVGCom's text file; the record keeps every sample</source>
            <translation>Строк в секунду в текстовом файле CVGCom; запись хранит каждый отсчёт</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Write CVGCom's text file too</source>
            <translation>Писать и текст CVGCom</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>File name</source>
            <translation>Имя файла</translation>
        </message>
        <message>
            <location filename="../../gui/live/settings_view.py" />
            <source>Channels</source>
            <translation>Каналы</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Order of U0</source>
            <translation>Порядок U0</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Of the bias; of the outputs of a standing unit. Found: by temperatures left out.</source>
            <translation>Нулевого сигнала; выходов неподвижного изделия. Найденный: по исключённым температурам.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Order of k</source>
            <translation>Порядок k</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Of the scale factor.</source>
            <translation>Масштабного коэффициента.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>T0</source>
            <translation>T0</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>The constant terms hold at this temperature.</source>
            <translation>Постоянные члены действительны при этой температуре.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>g</source>
            <translation>g</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Taken where the files state none.</source>
            <translation>Берётся там, где файлы его не указывают.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Outputs</source>
            <translation>Выходы</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>Of a record: names, between commas.</source>
            <translation>Записи: имена через запятую.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>the first</source>
            <translation>первый</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/settings_view.py" />
            <source>all rates</source>
            <translation>все</translation>
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
            <translation>{kind} по углам делительной головки</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>angles</source>
            <translation>углы</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>angle</source>
            <translation>угол</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>Angles</source>
            <translation>Углы</translation>
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
            <translation>лимб {angle}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>No pitch, no roll</source>
            <translation>Ни тангажа, ни крена</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/guide.py" />
            <source>{name} sends neither angles nor three accelerometers: there is nothing to check here. Choose another device.</source>
            <translation>{name} не передаёт ни углов, ни трёх акселерометров: здесь нечего проверять. Выберите другое устройство.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>Nearest in the archive: {words}</source>
            <translation>Ближайшая в архиве: {words}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>The check has no calibration: only the unit's own angles are judged.</source>
            <translation>У проверки нет калибровки: оцениваются только собственные углы изделия.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>Use judges the raw codes too, by this calibration.</source>
            <translation>«Взять» оценит по этой калибровке и коды.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>Use</source>
            <translation>Взять</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>{angle} error, deg</source>
            <translation>{angle}: погрешность, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>deg</source>
            <translation>deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>{angle} while {other} is set, deg</source>
            <translation>{angle}, когда задано {other}, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>The unit tells no heading.</source>
            <translation>Изделие не передаёт курса.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>Heading, change against the first row, deg</source>
            <translation>Курс, изменение относительно первой строки, deg</translation>
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
            <translation>Температуры, изменение относительно первой строки, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/picture.py" />
            <source>The unit tells no temperature.</source>
            <translation>Изделие не передаёт температуры.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/results.py" />
            <source>No file is loaded.</source>
            <translation>Файл не загружен.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/results.py" />
            <source>The file has {rows} rows, the list {angles} angles.</source>
            <translation>В файле {rows} [строка|строки|строк], в списке — {angles} [угол|угла|углов].</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>The list belongs to the session; press New session to change it.</source>
            <translation>Список принадлежит сеансу; чтобы изменить его, нажмите «Новый сеанс».</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>The list Angles stays as it was</source>
            <translation>Список Angles остаётся, как был</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>Type one angle for every row, in degrees, as 0, 30, 60; or press New session.</source>
            <translation>Введите по одному углу на каждую строку, в градусах, как 0, 30, 60; или нажмите «Новый сеанс».</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{device}: {kind} accuracy, {count} angles</source>
            <translation>{device}: точность, {kind}, {count} [угол|угла|углов]</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{kind} Accuracy, deg</source>
            <translation>Точность, {kind}, deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Trace</source>
            <translation>Кривая</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Verdict</source>
            <translation>Решение</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Set</source>
            <translation>Задано</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>in-plane angle atan2(a_y, a_z) less set angle: the pitch of a full turn</source>
            <translation>угол в плоскости atan2(a_y, a_z) минус заданный: тангаж полного оборота</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>angle less set angle</source>
            <translation>угол минус заданный</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Errors, deg, with U (95 %)</source>
            <translation>Погрешности, deg, с U (95 %)</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Table {number}: codes, m/s², deg</source>
            <translation>Таблица {number}: коды, m/s², deg</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{kind} by the unit</source>
            <translation>{kind} по изделию</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{kind} calculated</source>
            <translation>{kind} вычисленный</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>u of the calibration</source>
            <translation>u калибровки</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Calibration: {name}.</source>
            <translation>Калибровка: {name}.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>No calibration: the unit's own angles alone.</source>
            <translation>Без калибровки: только собственные углы изделия.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>No limit is stated: there is no verdict. {calibration}</source>
            <translation>Предел не указан: решения нет. {calibration}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Limit ±{limit}° at every angle. {rule}. U counts {parts}. {calibration}</source>
            <translation>Предел ±{limit}° для каждого угла. {rule}. U учитывает {parts}. {calibration}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>the setting of the head, the resolution of reported angles, and the noise of the mean</source>
            <translation>установку головки, разрешение передаваемых углов и шум среднего</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>largest error {error}° at {angle}°</source>
            <translation>наибольшая погрешность {error}° при {angle}°</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>{count} of {total} angles</source>
            <translation>{count} из {total} [угла|углов|углов]</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Calibration</source>
            <translation>Калибровка</translation>
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
            <translation>Оси наклонителя выровнены</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>PASS</source>
            <translation>СООТВЕТСТВУЕТ</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>FAIL</source>
            <translation>НЕ СООТВЕТСТВУЕТ</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>UNDECIDED</source>
            <translation>НЕ РЕШЕНО</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>{angle} Error</source>
            <translation>{angle}: погрешность</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Heading</source>
            <translation>Курс</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Current {angle}</source>
            <translation>{angle}: текущее</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/texts.py" />
            <source>Temperature</source>
            <translation>Температура</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/written.py" />
            <source>Verdict and tables, CSV</source>
            <translation>Решение и таблицы, CSV</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/written.py" />
            <source>Verdict and tables, CSV with decimal comma</source>
            <translation>Решение и таблицы, CSV с десятичной запятой</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/written.py" />
            <source>Run file of the rows</source>
            <translation>Файл серии со строками</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>{method}: {rows} accumulations, {time}; {dof} more than unknowns</source>
            <translation>{method}: {rows} [накопление|накопления|накоплений], {time}; на {dof} больше, чем неизвестных</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>This plan shows all that the method can tell</source>
            <translation>Этот план показывает всё, что может сказать метод</translation>
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
            <translation>ограничивает</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>whole plan</source>
            <translation>весь план</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>Predicted before measuring</source>
            <translation>Предсказано до измерения</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>From the design matrix, the noise, the settings, g</source>
            <translation>По матрице плана, шуму, установкам, g</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>The plan is not saved</source>
            <translation>План не сохранён</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>The plan is saved: {path}</source>
            <translation>План сохранён: {path}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>No tab can take this plan now</source>
            <translation>Ни одна вкладка не может сейчас взять этот план</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Its test is {test}, or an accumulation is running.</source>
            <translation>Его испытание — {test}, или идёт накопление.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>End the session in its tab by New session, then open it again.</source>
            <translation>Завершите сеанс в его вкладке через «Новый сеанс», затем откройте его снова.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>A plan of your own is refused</source>
            <translation>Ваш собственный план отклонён</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>{title}, own {count}</source>
            <translation>{title}, собственный {count}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Nothing can be predicted</source>
            <translation>Ничего предсказать нельзя</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Added</source>
            <translation>Добавлено</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>The plans are being compared …</source>
            <translation>Планы сравниваются …</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>State the white noise N of the sensor at the left, or take it from a record.</source>
            <translation>Укажите слева белый шум N датчика или возьмите его из записи.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>No plan measures this sensor with the tools that are ticked at the left.</source>
            <translation>Ни один план не измерит этот датчик средствами, отмеченными слева.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>There is no plan that would work.</source>
            <translation>Нет плана, который работал бы.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Open this plan</source>
            <translation>Открыть этот план</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Restore all steps</source>
            <translation>Вернуть все шаги</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Nothing was changed.</source>
            <translation>Ничего не изменено.</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Export</source>
            <translation>Экспорт</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>{count} parameters</source>
            <translation>параметров: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>white noise</source>
            <translation>белый шум</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>flicker, walk</source>
            <translation>фликкер, блуждание</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>settings</source>
            <translation>установки</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>local g</source>
            <translation>местное g</translation>
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
            <translation>График, {suffix}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Nothing is chosen.</source>
            <translation>Ничего не выбрано.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>All that there is of it is shown here.</source>
            <translation>Всё, что о нём есть, показано здесь.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>The archive is being worked at.</source>
            <translation>Архив занят работой.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Open</source>
            <translation>Открыть</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Certificate</source>
            <translation>Сертификат</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Choose a session, a run, an old file, a record or a calibration.</source>
            <translation>Выберите сеанс, файл измерения, старый файл, запись или калибровку.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Import Folder</source>
            <translation>Импорт папки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Decode Again</source>
            <translation>Декодировать снова</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Choose a session: its raw bytes are decoded again and compared.</source>
            <translation>Выберите сеанс: его необработанные байты будут снова декодированы и сравнены.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Refresh</source>
            <translation>Обновить</translation>
        </message>
        <message>
            <location filename="../../gui/archive/actions.py" />
            <source>Rebuild Index</source>
            <translation>Перестроить индекс</translation>
        </message>
        <message>
            <location filename="../../gui/archive/exporting.py" />
            <source>Tables, CSV (1.5, …)</source>
            <translation>Таблицы, CSV (1.5, …)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/exporting.py" />
            <source>Tables, CSV (1,5; …)</source>
            <translation>Таблицы, CSV (1,5; …)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The sessions are untouched. When the cause is gone press Refresh (Ctrl+R).</source>
            <translation>Сеансы не затронуты. Когда причина устранена, нажмите «Обновить» (Ctrl+R).</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The archive cannot be searched</source>
            <translation>В архиве невозможно искать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The archive cannot be opened</source>
            <translation>Архив невозможно открыть</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The index cannot be made</source>
            <translation>Индекс невозможно создать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The sessions are untouched. When the cause is gone press Refresh (Ctrl+R): what is missing in the list comes back from the files.</source>
            <translation>Сеансы не затронуты. Когда причина устранена, нажмите «Обновить» (Ctrl+R): чего недостаёт в списке, вернётся из файлов.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The entry cannot be shown</source>
            <translation>Запись невозможно показать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The list is looked up again; choose the entry once more.</source>
            <translation>Список составляется заново; выберите запись ещё раз.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The history cannot be shown</source>
            <translation>Историю невозможно показать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The folder cannot be imported</source>
            <translation>Папку невозможно импортировать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>What was taken in stays. Put right what is named and import the folder again: it goes on where it was broken off.</source>
            <translation>Что уже взято, остаётся. Исправьте названное и импортируйте папку снова: импорт продолжится с места, где был прерван.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The session cannot be decoded</source>
            <translation>Сеанс невозможно декодировать</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>The stored means stay as they are. The raw bytes (.calrec) belong into the session's folder or into the folder raw.</source>
            <translation>Сохранённые средние остаются как были. Сырые байты (.calrec) должны лежать в папке сеанса или в папке raw.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Nothing has to be done. If it happens again, have the disk checked.</source>
            <translation>Ничего делать не нужно. Если это повторится, проверьте диск.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Searching works as always. To measure, choose a folder that can be written to.</source>
            <translation>Поиск работает как всегда. Чтобы измерять, выберите папку, в которую можно писать.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Update CalRig on this computer; until then measure as always, the newer program finds the sessions.</source>
            <translation>Обновите CalRig на этом компьютере; до тех пор измеряйте как всегда: новая программа найдёт сеансы.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/failures.py" />
            <source>Open it by Load Data of the tab in which it was measured.</source>
            <translation>Откройте его кнопкой «Загрузить данные» той вкладки, где он был измерен.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>{marked} of {all} parameters differ by more than 2 u</source>
            <translation>{marked} из {all} [параметра|параметров|параметров] отличаются более чем на 2 u</translation>
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
            <translation>значение</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>unit</source>
            <translation>единица</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>limits</source>
            <translation>пределы</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Parameters, U for 95 %</source>
            <translation>Параметры, U для 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>pass: value ± U within the limits; fail: beyond; else undecided (JCGM 106)</source>
            <translation>соответствует: значение ± U в пределах; не соответствует: за пределами; иначе не решено (JCGM 106)</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>verdict</source>
            <translation>решение</translation>
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
            <translation>файл устройства</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>temperature, °C</source>
            <translation>температура, °C</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>What it is</source>
            <translation>Что это</translation>
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
            <translation>положения</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>rows</source>
            <translation>строки</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>measured</source>
            <translation>измерено</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>days later</source>
            <translation>дней спустя</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Nearest calibrations by date and temperature</source>
            <translation>Ближайшие калибровки по дате и температуре</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>first</source>
            <translation>первая</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>second</source>
            <translation>вторая</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>d = second minus first</source>
            <translation>d = вторая минус первая</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>u² = u₁² + u₂²;  U = 2 u;  differs: |d| &gt; 2 u</source>
            <translation>u² = u₁² + u₂²;  U = 2 u;  отличается: |d| &gt; 2 u</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>History of {name}, {n} calibrations</source>
            <translation>История {name}, калибровок: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>what</source>
            <translation>что</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>file</source>
            <translation>файл</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Files</source>
            <translation>Файлы</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Import</source>
            <translation>Импорт</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>no files</source>
            <translation>нет файлов</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>{same} of {all} positions give the same means</source>
            <translation>{same} из {all} [положения|положений|положений] дают те же средние</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>position</source>
            <translation>положение</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>samples</source>
            <translation>отсчёты</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>again</source>
            <translation>снова</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>largest d / se</source>
            <translation>наибольшее d / se</translation>
        </message>
        <message>
            <location filename="../../gui/archive/findings.py" />
            <source>Decoded again from the raw bytes</source>
            <translation>Декодировано снова из необработанных байтов</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>There is no tab {title} to open it in</source>
            <translation>Нет вкладки {title}, чтобы открыть</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>The archive</source>
            <translation>Архив</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>all temperatures</source>
            <translation>все температуры</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>{done} of {all} taken in …</source>
            <translation>взято {done} из {all} …</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>The archive is being opened …</source>
            <translation>Архив открывается …</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>the latest {shown} of {all}</source>
            <translation>последние {shown} из {all}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>{all} found</source>
            <translation>найдено: {all}</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>Nothing is in the archive yet.

Every session and calibration of the folder of sessions comes here by itself. Import Folder (Ctrl+I) copies old files into it: those of ClbAcc, Pointer, ClbDUS and CVGCom, run files, whole sessions.</source>
            <translation>В архиве ещё ничего нет.

Каждый сеанс и каждая калибровка из папки сеансов попадают сюда сами. «Импорт папки» (Ctrl+I) копирует сюда старые файлы: ClbAcc, Pointer, ClbDUS и CVGCom, файлы серий, целые сеансы.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>Choose an entry to see its parameters and their history; hold Ctrl and choose a second one to compare them.</source>
            <translation>Выберите запись, чтобы увидеть её параметры и их историю; удерживайте Ctrl и выберите вторую, чтобы сравнить.</translation>
        </message>
        <message>
            <location filename="../../gui/archive/presenter.py" />
            <source>There is no calibration of this device whose parameters could be followed.</source>
            <translation>Нет калибровки этого устройства, за параметрами которой можно следить.</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/page.py" />
            <source>Table, CSV</source>
            <translation>Таблица, CSV</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/page.py" />
            <source>Table, CSV with decimal comma</source>
            <translation>Таблица, CSV с десятичной запятой</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/presenter.py" />
            <source>Add calibrations of gyros, runs on the rate table or on the head, and the coefficients that the Allan tab exports. Files of one unit share a column: give them the same name.</source>
            <translation>Добавьте калибровки гироскопов, серии на поворотном столе или на головке и коэффициенты, которые экспортирует вкладка Аллана. Файлы одного изделия делят столбец: дайте им одно имя.</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/presenter.py" />
            <source>{name} is not compared</source>
            <translation>{name} не сравнивается</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/presenter.py" />
            <source>Not compared</source>
            <translation>Не сравнено</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Gyros side by side (lab 6)</source>
            <translation>Гироскопы рядом (лабораторная 6)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Value ± U (95 %). {star} the smallest of its row, where they can be compared.</source>
            <translation>Значение ± U (95 %). {star} наименьшее в своей строке, где их можно сравнить.</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Quantity</source>
            <translation>Величина</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>not measured</source>
            <translation>не измерено</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source> or </source>
            <translation> или </translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>a run on the rate table</source>
            <translation>серию на поворотном столе</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>positions on the dividing head</source>
            <translation>положения на делительной головке</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>an Allan analysis (Export, Coefficients CSV)</source>
            <translation>анализ Аллана (Экспорт, Коэффициенты CSV)</translation>
        </message>
        <message>
            <location filename="../../gui/comparison/tables.py" />
            <source>{names}: no {quantity}; add {file}</source>
            <translation>{names}: нет «{quantity}»; добавьте {file}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>The numbers come with the first sample of a device.</source>
            <translation>Числа появятся с первым отсчётом устройства.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Channel</source>
            <translation>Канал</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Now</source>
            <translation>Сейчас</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Mean, 1 s</source>
            <translation>Среднее, 1 s</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>STD, 1 s</source>
            <translation>СКО, 1 s</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Mean</source>
            <translation>Среднее</translation>
        </message>
        <message>
            <location filename="../../gui/devices/adc.py" />
            <source>Calibrated, 1 s</source>
            <translation>Калибровано, 1 s</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>The device is not stopped</source>
            <translation>Устройство не остановлено</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>The port is closed</source>
            <translation>Порт закрыт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>The device file of {name} knows no stop command; the device goes on sending.</source>
            <translation>Файл устройства {name} не знает команды остановки; устройство передаёт дальше.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>{name} was told to stop</source>
            <translation>{name}: передана команда остановки</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>Its device file knows no start command: switch it off and on to have it send again.</source>
            <translation>Его файл устройства не знает команды запуска: выключите и включите его, чтобы он передавал снова.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>{name} goes on sending</source>
            <translation>{name} передаёт дальше</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>It did not obey the stop command of its device file.</source>
            <translation>Он не выполнил команду остановки из своего файла устройства.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/stopping.py" />
            <source>Start Device</source>
            <translation>Запустить устройство</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Could still be added; nothing asks for it</source>
            <translation>Ещё можно добавить; ничто этого не требует</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>How it shows</source>
            <translation>Как проявляется</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>What to do</source>
            <translation>Что делать</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>effect</source>
            <translation>эффект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>named from</source>
            <translation>заметно от</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>usual</source>
            <translation>обычно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Smallest effects that these rows would name</source>
            <translation>Наименьшие эффекты, которые эти строки назвали бы</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>size at which eight sigmas of the effect are visible</source>
            <translation>величина, при которой видно восемь сигм эффекта</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Looks the same in these rows</source>
            <translation>В этих строках выглядит так же</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>as</source>
            <translation>как</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>invisible, whatever its size</source>
            <translation>невидим, как бы ни был велик</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>needs the column {name}</source>
            <translation>нужен столбец {name}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Not to be seen in these rows</source>
            <translation>Не видно в этих строках</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>from {size} on</source>
            <translation>от {size}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>from {size} on; usual {usual}</source>
            <translation>от {size}; обычно {usual}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{detail}; looks the same: {others}</source>
            <translation>{detail}; так же выглядят: {others}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>Fits these rows as well: {names}</source>
            <translation>К этим строкам так же подходит: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. A fault of the data</source>
            <translation>{number}. Порок данных</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. No effect explains this</source>
            <translation>{number}. Ни один эффект этого не объясняет</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. The best name, or something outside the catalogue</source>
            <translation>{number}. Лучшее название или что-то вне каталога</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. These cannot be told apart yet</source>
            <translation>{number}. Эти пока не различить</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. A term of the noise</source>
            <translation>{number}. Составляющая шума</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{number}. Missing in the model</source>
            <translation>{number}. Недостаёт в модели</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>evidence {nats}, {share} %</source>
            <translation>свидетельство {nats}, {share} %</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>gap {gap}</source>
            <translation>расхождение {gap}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{count} positions, {minutes} min</source>
            <translation>положений: {count}, {minutes} min</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{count} rates, {minutes} min</source>
            <translation>скоростей: {count}, {minutes} мин</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>{why}. Tells apart: {names}.</source>
            <translation>{why}. Различает: {names}.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>a fault of the data, counted in them</source>
            <translation>порок данных, посчитан в них</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>no effect of the catalogue fits</source>
            <translation>ни один эффект каталога не подходит</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>at the best roughly: {names}</source>
            <translation>разве что приблизительно: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>a term of the noise, no fault</source>
            <translation>составляющая шума, не неисправность</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>no other name fits</source>
            <translation>никакое другое название не подходит</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>but could also be something outside the catalogue</source>
            <translation>но может быть и чем-то вне каталога</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>but could also be {names}, or something outside the catalogue</source>
            <translation>но может быть и {names} или что-то вне каталога</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>but could also be {names}</source>
            <translation>но может быть и {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/certainty.py" />
            <source>{names} and {count} further names</source>
            <translation>{names} и ещё названий: {count}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Report, PDF</source>
            <translation>Отчёт, PDF</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Report, HTML</source>
            <translation>Отчёт, HTML</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Results, JSON</source>
            <translation>Результаты, JSON</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>Model, JSON</source>
            <translation>Модель, JSON</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>A session holds another plan, or an accumulation is running.</source>
            <translation>Сеанс держит другой план, или идёт накопление.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>The plan is not kept</source>
            <translation>План не сохранён</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>The plan is kept</source>
            <translation>План сохранён</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>{path}: after the next start it stands among the plans of its tab.</source>
            <translation>{path}: после следующего запуска он будет среди планов своей вкладки.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>Plain model</source>
            <translation>Простая модель</translation>
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
            <translation>исключённые {value}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>evidence {value}</source>
            <translation>свидетельство {value}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>from replicates</source>
            <translation>из повторений</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>from standard errors</source>
            <translation>из стандартных погрешностей</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>from the residuals</source>
            <translation>из остатков</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/ladder_rows.py" />
            <source>noise floor {size} {unit}, {source}</source>
            <translation>уровень шума {size} {unit}, {source}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>{device}: {rows} samples</source>
            <translation>{device}: отсчётов {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>{device}: {rows} rows</source>
            <translation>{device}: строк {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>{device}: {rows} rows × {count} outputs</source>
            <translation>{device}: строк {rows} × выходов {count}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Look at the residuals, and answer on the page Practice.</source>
            <translation>Посмотрите остатки и ответьте на странице «Тренировка».</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Record for longer.</source>
            <translation>Записывайте дольше.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Measure more positions, and each twice; then load both files together.</source>
            <translation>Измерьте больше положений, каждое дважды; затем загрузите оба файла вместе.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Find (Space) looks for the reason.</source>
            <translation>«Найти» (Space) ищет причину.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Find (Space) looks closer.</source>
            <translation>«Найти» (Space) присматривается внимательнее.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Nothing to add. “What can be seen” tells how small an effect would have been named.</source>
            <translation>Добавлять нечего. «Что можно увидеть» говорит, какой малый эффект был бы назван.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Measure once more: noise goes another way then, a cause does not.</source>
            <translation>Измерьте ещё раз: шум тогда пойдёт иначе, причина — нет.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Measure next: {title}, {minutes} min; it decides with {chance} %. Then load both files together.</source>
            <translation>Измерьте далее: {title}, {minutes} мин; решит на {chance} %. Затем загрузите оба файла вместе.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Record next: {title}, {minutes} min; it decides with {chance} %.</source>
            <translation>Запишите далее: {title}, {minutes} мин; решит на {chance} %.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Look at rig and sensor where the curve is largest, and measure more densely there.</source>
            <translation>Осмотрите стенд и датчик там, где кривая наибольшая, и измерьте там гуще.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>No series that was tried would decide; only knowledge from elsewhere can.</source>
            <translation>Ни одна из проверенных серий не решила бы; может лишь знание из другого источника.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Add to Model (Ctrl+Return); a new series then confirms the name.</source>
            <translation>«В модель» (Ctrl+Return); название затем подтвердит новая серия.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Report (Ctrl+E); a second record confirms the name.</source>
            <translation>«Отчёт» (Ctrl+E); название подтвердит вторая запись.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/overview.py" />
            <source>Use in Calibration (F7); a new series with other angles or order confirms the name.</source>
            <translation>«В калибровку» (F7); название подтвердит новая серия с другими углами или порядком.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/picture.py" />
            <source>{name}: what the effects so far leave, largest {place}</source>
            <translation>{name}: что оставляют добавленные эффекты, наибольшее {place}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/picture.py" />
            <source>{name}: structure beyond the noise, {p}, largest {place}</source>
            <translation>{name}: структура сверх шума, {p}, наибольшее {place}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/picture.py" />
            <source>{name}: no structure beyond the noise, {p}, largest {place}</source>
            <translation>{name}: структуры сверх шума нет, {p}, наибольшее {place}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/presenter.py" />
            <source>No tab calibrates this run</source>
            <translation>Ни одна вкладка не калибрует по этому измерению</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/presenter.py" />
            <source>Model and data cannot be compared</source>
            <translation>Модель и данные невозможно сравнить</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Model vs data: {device}</source>
            <translation>Модель и данные: {device}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>The ladder</source>
            <translation>Лестница</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>times the noise floor; 1 is the best</source>
            <translation>уровней шума; лучше всего — 1</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>model</source>
            <translation>модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>gap</source>
            <translation>расхождение</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>held out</source>
            <translation>исключённые</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>rms, {unit}</source>
            <translation>СКО, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>gap: rms of the whitened residuals; 1 (dotted) is the noise floor, {size} {unit} rms; the stroke: the gap of rows that were left out of the fit</source>
            <translation>расхождение: СКО отбелённых остатков; 1 (пунктир) — уровень шума, {size} {unit} СКО; черта: расхождение строк, исключённых из оценки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Residual with the effects added</source>
            <translation>Остаток с добавленными эффектами</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Residual of the plain model</source>
            <translation>Остаток простой модели</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Points: rows. Line: their smooth structure. Band: where all means of a right model stay (95 %); those that leave it are diamonds, and their stretches are tinted.</source>
            <translation>Точки: строки. Линия: их гладкая структура. Полоса: где остаются все средние правильной модели (95 %); те, что выходят из неё, — ромбы, а их участки затенены.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>evidence {evidence} nats, probability {share} among the names, {p}</source>
            <translation>свидетельство {evidence} nats, вероятность {share} среди названий, {p}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Cannot be told from: {names}</source>
            <translation>Не отличить от: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>regressor</source>
            <translation>регрессор</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>before</source>
            <translation>до</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>largest</source>
            <translation>наибольшая</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>after</source>
            <translation>после</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>Where the residual has structure</source>
            <translation>Где остаток имеет структуру</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>p adjusted for all regressors together (Westfall and Young)</source>
            <translation>p с поправкой на все регрессоры вместе (Уэстфолл и Янг)</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>series</source>
            <translation>серия</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>why</source>
            <translation>почему</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>effort</source>
            <translation>усилия</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>decides, %</source>
            <translation>решает, %</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/report.py" />
            <source>What to measure next</source>
            <translation>Что измерить далее</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>There is nothing to compare yet.</source>
            <translation>Сравнивать ещё нечего.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Nothing was measured yet.</source>
            <translation>Ещё ничего не измерено.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>The case is sealed: answer first.</source>
            <translation>Случай запечатан: сначала ответьте.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Find proposes effects first.</source>
            <translation>Сначала «Найти» предлагает эффекты.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Find</source>
            <translation>Найти</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Add to Model</source>
            <translation>В модель</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Add All</source>
            <translation>Добавить все</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Undo</source>
            <translation>Отменить</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Nothing was added.</source>
            <translation>Ничего не добавлено.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Simulate with This Model</source>
            <translation>Симулировать</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Hide Simulation</source>
            <translation>Без симуляции</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Use in Calibration</source>
            <translation>В калибровку</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Load Data</source>
            <translation>Загрузить данные</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Report</source>
            <translation>Отчёт</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Practice</source>
            <translation>Тренировка</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>A sealed case</source>
            <translation>Запечатанный случай</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>The plain model is rejected</source>
            <translation>Простая модель отвергнута</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>No regressor speaks against the plain model</source>
            <translation>Ни один регрессор не свидетельствует против простой модели</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>This plan can show nothing</source>
            <translation>Этот план не может показать ничего</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Its rows leave nothing that could contradict the plain model: measure more positions, and each twice.</source>
            <translation>Его строки не оставляют ничего, что могло бы противоречить простой модели: измерьте больше положений, и каждое дважды.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>What this plan can show</source>
            <translation>Что может показать этот план</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>{alone} effects by themselves, {tied} only together with others, {hidden} not at all; for usual sensors on a usual head or table.</source>
            <translation>Эффектов отдельно: {alone}, только вместе с другими: {tied}, совсем нет: {hidden}; для обычных датчиков на обычной головке или столе.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>Load Data (Ctrl+O) takes a session's folder, run files, records or text files of the old programs; several of one unit are compared as one run.

Find (Space) then looks for what the model lacks, names it, and says how sure that is; or press “Model vs data” on a page of results.

Practice (F8) hides something in rows of the simulated rig, for you to name.</source>
            <translation>«Загрузить данные» (Ctrl+O) берёт папку сеанса, файлы измерений, записи или текстовые файлы старых программ; несколько файлов одного изделия сравниваются как одно измерение.

«Найти» (Space) затем ищет, чего не хватает модели, называет это и говорит, насколько это надёжно; или нажмите «Модель и данные» на странице результатов.

«Тренировка» (F8) прячет что-нибудь в строках имитированного стенда, чтобы назвали вы.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Case {number}</source>
            <translation>Случай {number}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>correct</source>
            <translation>верно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>not correct</source>
            <translation>неверно</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Step {number} of the program: {names}</source>
            <translation>Шаг {number} программы: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Hidden: {names}</source>
            <translation>Скрыто: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>You: {names} ({verdict})</source>
            <translation>Вы: {names} ({verdict})</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Program: {count} named ({verdict})</source>
            <translation>Программа: названо {count} ({verdict})</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>The seal is the SHA-256 of this text: {key}</source>
            <translation>Печать — это SHA-256 такого текста: {key}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>No case was opened yet.</source>
            <translation>Ни один случай ещё не открыт.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>Of {cases} cases you had {operator} right, the program {program}.</source>
            <translation>Из {cases} [случая|случаев|случаев] вы угадали {operator}, программа — {program}.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>accelerometer on the dividing head</source>
            <translation>акселерометр на делительной головке</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>gyro on the rate table</source>
            <translation>гироскоп на поворотном стенде</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>gyro at rest on the head</source>
            <translation>неподвижный гироскоп на головке</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>record of a vibratory gyro</source>
            <translation>запись вибрационного гироскопа</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>nothing is missing</source>
            <translation>ничего не недостаёт</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Reading the rows …</source>
            <translation>Чтение строк …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Walking the plan with usual sensors …</source>
            <translation>Прохождение плана с обычными датчиками …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Measuring a sealed case …</source>
            <translation>Измерение запечатанного случая …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Estimating the noise floor …</source>
            <translation>Оценка уровня шума …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Looking where the residuals are …</source>
            <translation>Поиск, где лежат остатки …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Trying all effects, also in sets …</source>
            <translation>Проверка всех эффектов, также наборами …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Fitting what was found, and what could decide …</source>
            <translation>Оценка найденного и того, что могло бы решить …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Fitting the model with the effect …</source>
            <translation>Оценка модели с эффектом …</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Walking the rows on the simulated rig …</source>
            <translation>Проход строк на имитированном стенде…</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>The model explains the data</source>
            <translation>Модель объясняет данные</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>An effect is missing, and named</source>
            <translation>Недостаёт эффекта, он назван</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>An effect is missing; several names fit</source>
            <translation>Недостаёт эффекта; подходит несколько названий</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Structure that no effect explains</source>
            <translation>Структура, которой не объясняет ни один эффект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>More noise than is stated</source>
            <translation>Шума больше, чем указано</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>The data are at fault</source>
            <translation>Виноваты данные</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Too few rows to tell</source>
            <translation>Слишком мало строк для ответа</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Model and data agree now</source>
            <translation>Модель и данные теперь согласуются</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>They agree now; several names fit</source>
            <translation>Теперь согласуются; подходит несколько названий</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Head angle</source>
            <translation>Угол головки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Set rate</source>
            <translation>Заданная скорость</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>a_x along case X</source>
            <translation>a_x вдоль X корпуса</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>a_y along case Y</source>
            <translation>a_y вдоль Y корпуса</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>a_z along case Z</source>
            <translation>a_z вдоль Z корпуса</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Order of measuring</source>
            <translation>Порядок измерения</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Time since the mounting</source>
            <translation>Время от установки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Rate of temperature</source>
            <translation>Скорость изменения температуры</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Position, number</source>
            <translation>Положение, номер</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Mounting, number</source>
            <translation>Установка, номер</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Pass of the plan</source>
            <translation>Проход плана</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Direction of approach</source>
            <translation>Направление подхода</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Setting before</source>
            <translation>Предыдущая уставка</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Output</source>
            <translation>Выход</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Frequency</source>
            <translation>Частота</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>Unexplained structure</source>
            <translation>Необъяснённая структура</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>The gap goes from {before} to {after} noise floors.</source>
            <translation>Расхождение уменьшается с {before} до {after} уровней шума.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>No effect stands out of the noise.</source>
            <translation>Ни один эффект не выступает из шума.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/words.py" />
            <source>{named}. {closing}</source>
            <translation>{named}. {closing}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>The session went through {count} temperatures</source>
            <translation>Сеанс прошёл через {count} температур</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>Process Data takes one temperature at a time; the Thermal tab takes them together: bias and scale factor against temperature, hysteresis.</source>
            <translation>«Обработать данные» берёт по одной температуре; вкладка «Термо» берёт их вместе: нулевой сигнал и масштабный коэффициент по температуре, гистерезис.</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>Open in Thermal</source>
            <translation>Открыть в «Термо»</translation>
        </message>
        <message>
            <location filename="../../gui/drift/exporting.py" />
            <source>Plots, {suffix}</source>
            <translation>Графики, {suffix}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>{p} knots × {m} temperatures, {bytes} bytes</source>
            <translation>{p} [узел|узла|узлов] × {m} [температура|температуры|температур], {bytes} [байт|байта|байтов]</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source> of {memory}</source>
            <translation> из {memory}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>{n} turn-ons, {low} … {high}; from {start} to {stop} s. The start is brought to zero over {begin} … {end} s, whose noise u = {noise} {unit} every correction carries.</source>
            <translation>{n} [включение|включения|включений], {low} … {high}; от {start} до {stop} s. Начало сведено к нулю за {begin} … {end} s; шум этого u = {noise} {unit} несёт каждая коррекция.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>No table</source>
            <translation>Таблицы нет</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Left on turn-ons that were not seen</source>
            <translation>Остаётся на не виденных включениях</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Each turn-on is left out in turn and corrected by what the others gave; rms of block means.</source>
            <translation>Каждое включение по очереди исключено и исправлено по тому, что дали остальные; СКО средних по блокам.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>× table</source>
            <translation>× таблица</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>bytes</source>
            <translation>байты</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>knot</source>
            <translation>узел</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>t, s</source>
            <translation>t, s</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>The table</source>
            <translation>Таблица</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Linear between knots and, by values, between temperatures of the chip.</source>
            <translation>Линейно между узлами и, по значениям, между температурами кристалла.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Temperature nodes, rms in {unit}</source>
            <translation>Температурные узлы, СКО в {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>Without the node: its turn-ons corrected by values interpolated between its neighbours. Much more than with it means that the nodes are too far apart.</source>
            <translation>Без узла: его включения исправлены значениями, интерполированными между соседями. Намного больше, чем с ним, означает, что узлы слишком далеки.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>chip</source>
            <translation>кристалл</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>turn-ons</source>
            <translation>включения</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>quartic</source>
            <translation>четвёртая степень</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>table</source>
            <translation>таблица</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>without node</source>
            <translation>без узла</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>By number of knots</source>
            <translation>По числу узлов</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>The fewest that leave at most 2 % more than the best are taken.</source>
            <translation>Берётся наименьшее, которое оставляет не более чем на 2 % больше лучшего.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/findings.py" />
            <source>tp</source>
            <translation>tp</translation>
        </message>
        <message>
            <location filename="../../gui/drift/picture.py" />
            <source>cost {cost} {unit} rms on the means (optimal {best}), {p} knots, {bytes} bytes</source>
            <translation>цена {cost} {unit} СКО на средних (оптимум {best}), {p} [узел|узла|узлов], {bytes} [байт|байта|байтов]</translation>
        </message>
        <message>
            <location filename="../../gui/drift/picture.py" />
            <source>mean</source>
            <translation>среднее</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>{name} is no turn-on</source>
            <translation>{name} не является включением</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Remove it from the list, or choose another output at the left.</source>
            <translation>Уберите его из списка или выберите другой выход слева.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Simulated gyro</source>
            <translation>Симулированный гироскоп</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>is being read …</source>
            <translation>читается …</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>1 turn-on</source>
            <translation>1 включение</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>{n} turn-ons</source>
            <translation>включений: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>{seconds} s</source>
            <translation>{seconds} s</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>All temperatures</source>
            <translation>Все температуры</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>There is no table yet.</source>
            <translation>Таблицы ещё нет.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>The knots stand where the search put them.</source>
            <translation>Узлы стоят там, где их поставил поиск.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Add Turn-ons</source>
            <translation>Добавить включения</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Add Folder</source>
            <translation>Добавить папку</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Simulated turn-ons</source>
            <translation>Симуляция</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Optimal knots</source>
            <translation>Оптимальные узлы</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Remove</source>
            <translation>Убрать</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>None is chosen.</source>
            <translation>Ничего не выбрано.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>The turn-ons are being read …</source>
            <translation>Включения читаются …</translation>
        </message>
        <message>
            <location filename="../../gui/drift/presenter.py" />
            <source>Add Turn-ons (Ctrl+O) reads records that began with switching on: recordings, files of CVGCom, run files, columns of numbers. About five at each temperature, at least 5 minutes apart so that the unit cools down.

Simulated turn-ons (F6) shows the tab on a made-up gyro.</source>
            <translation>«Добавить включения» (Ctrl+O) читает записи, начавшиеся с включения: записи программы, файлы CVGCom, файлы серий, столбцы чисел. Около пяти при каждой температуре, с перерывом не менее 5 минут, чтобы изделие остыло.

«Симуляция» (F6) показывает вкладку на вымышленном гироскопе.</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>no correction</source>
            <translation>без коррекции</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>cubic in time</source>
            <translation>куб времени</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>quartic in time</source>
            <translation>четвёртая степень времени</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>sharpest angles (003)</source>
            <translation>самые острые углы (003)</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>this table</source>
            <translation>эта таблица</translation>
        </message>
        <message>
            <location filename="../../gui/drift/texts.py" />
            <source>mean curve (floor)</source>
            <translation>средняя кривая (дно)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Planned seeking</source>
            <translation>Планируемое определение</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>{file}: {rows} readings</source>
            <translation>{file}: показаний {rows}</translation>
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
            <translation>Земля, горизонтальная составляющая</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>  by the latitude</source>
            <translation>  по широте</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Change of the drift</source>
            <translation>Изменение дрейфа</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Heading and drift</source>
            <translation>Курс и дрейф</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>As set</source>
            <translation>Как задано</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Best</source>
            <translation>Лучшее</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Enough for {target}°</source>
            <translation>Достаточно для {target}°</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>never with this gyro</source>
            <translation>никогда с этим гироскопом</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>u of the heading: {count} headings, {pause} s to turn, by N, B, K</source>
            <translation>u курса: {count} [курс|курса|курсов], {pause} s на поворот, по N, B, K</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>How long to average</source>
            <translation>Как долго усреднять</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>time, s</source>
            <translation>время, s</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Kept afterwards by the same gyro</source>
            <translation>Удержание затем тем же гироскопом</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>Its drift, as found, is subtracted</source>
            <translation>Его дрейф, как найден, вычтен</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/findings.py" />
            <source>for, h</source>
            <translation>в течение, h</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/page.py" />
            <source>Measurements (*.csv *.txt *.json *.jsonl)</source>
            <translation>Измерения (*.csv *.txt *.json *.jsonl)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/page.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>The file is refused</source>
            <translation>Файл отклонён</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>The run is being read …</source>
            <translation>Серия читается …</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>Heading from the rotation of the Earth, by one gyro turned on a level base.

Load Data (Ctrl+O) reads a run of headings: column head_deg is the reading of the base, clockwise; tilt_deg the elevation of the input axis by an accelerometer.

State the noise of the gyro at the left, or take it from a record, to see how long to average.</source>
            <translation>Курс по вращению Земли одним гироскопом, поворачиваемым на горизонтальном основании.

«Загрузить данные» (Ctrl+O) читает серию курсов: столбец head_deg — показание основания по часовой стрелке; tilt_deg — угол возвышения входной оси по акселерометру.

Укажите слева шум гироскопа или возьмите его из записи, чтобы увидеть, как долго усреднять.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/presenter.py" />
            <source>There is nothing to export yet.</source>
            <translation>Экспортировать ещё нечего.</translation>
        </message>
        <message>
            <location filename="../../gui/keys/key_html.py" />
            <source>Keys of CalRig</source>
            <translation>Клавиши CalRig</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Stop the accumulation</source>
            <translation>Остановить накопление</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Take the last one back</source>
            <translation>Отменить последнее</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Stop the record</source>
            <translation>Остановить запись</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Stop the live curve</source>
            <translation>Остановить живую кривую</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Hands-free</source>
            <translation>Без рук</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Search</source>
            <translation>Поиск</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Show the log</source>
            <translation>Показать журнал</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Device Properties</source>
            <translation>Свойства устройств</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>OK</source>
            <translation>OK</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Close</source>
            <translation>Закрыть</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Distance view</source>
            <translation>Вид издалека</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Leave it</source>
            <translation>Выйти из него</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>List of steps</source>
            <translation>Список шагов</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Look at another step</source>
            <translation>Посмотреть другой шаг</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Make it the current step</source>
            <translation>Сделать его текущим</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Pick a step by its place</source>
            <translation>Выбрать шаг по месту</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Charts over time</source>
            <translation>Графики по времени</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Move in time</source>
            <translation>Движение по времени</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Zoom in and out</source>
            <translation>Увеличить и уменьшить</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Show everything</source>
            <translation>Показать всё</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Follow the newest samples</source>
            <translation>Следить за новейшими отсчётами</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Other channels</source>
            <translation>Другие каналы</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Set a cursor at the pointer</source>
            <translation>Поставить курсор у указателя</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Move the cursor by a sample</source>
            <translation>Сдвинуть курсор на отсчёт</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Clear the cursors</source>
            <translation>Убрать курсоры</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Plots</source>
            <translation>Графики</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Allan plot</source>
            <translation>График Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Read the curve by points</source>
            <translation>Читать кривую по точкам</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Plot of the drift table</source>
            <translation>График таблицы дрейфа</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Choose a knot</source>
            <translation>Выбрать узел</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Move the knot</source>
            <translation>Сдвинуть узел</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Matrices, tables, log</source>
            <translation>Матрицы, таблицы, журнал</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Copy</source>
            <translation>Копировать</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Table of means</source>
            <translation>Таблица средних</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Paste a column of references</source>
            <translation>Вставить столбец заданных значений</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Dial of the simulated rig</source>
            <translation>Лимб симулированного стенда</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn by a step</source>
            <translation>Повернуть на шаг</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn by a fine step</source>
            <translation>Повернуть на мелкий шаг</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn by a quarter</source>
            <translation>Повернуть на четверть</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn to zero</source>
            <translation>Повернуть к нулю</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Preferences</source>
            <translation>Настройки</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Candidates</source>
            <translation>Кандидаты</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Choose it</source>
            <translation>Выбрать его</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Bytes of a board</source>
            <translation>Байты платы</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Point at another byte</source>
            <translation>Указать на другой байт</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Select bytes</source>
            <translation>Выделить байты</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Add a field</source>
            <translation>Добавить поле</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Remove the field</source>
            <translation>Убрать поле</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Preview of a certificate</source>
            <translation>Просмотр сертификата</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Turn the page</source>
            <translation>Перелистнуть страницу</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Tour</source>
            <translation>Обзор</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Go on</source>
            <translation>Дальше</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Message</source>
            <translation>Сообщение</translation>
        </message>
        <message>
            <location filename="../../gui/keys/sheet.py" />
            <source>Everywhere</source>
            <translation>Везде</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Click into the charts for cursor A, Shift+click for B.</source>
            <translation>Щёлкните по графикам для курсора A, Shift+щелчок — для B.</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Between the cursors</source>
            <translation>Между курсорами</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source> So were {n} others.</source>
            <translation> Так же ещё {n}.</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>A record was interrupted: {name}</source>
            <translation>Запись была прервана: {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>The program or the computer stopped while it ran.{more}</source>
            <translation>Программа или компьютер остановились во время записи.{more}</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>All up to about a second before stands in it; START begins the next record.</source>
            <translation>В ней есть всё, кроме примерно последней секунды; START начинает следующую запись.</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>Open it</source>
            <translation>Открыть её</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>The means are not handed over</source>
            <translation>Средние не переданы</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Rate table</source>
            <translation>Поворотный стол</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Dividing head</source>
            <translation>Делительная головка</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Run file written</source>
            <translation>Файл серии записан</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Load Data of the tab {tab} takes it.</source>
            <translation>Его принимает «Загрузить данные» вкладки {tab}.</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>set rate</source>
            <translation>заданная скорость</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>has no {what} yet</source>
            <translation>ещё не имеет {what}</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Set rate, °/s</source>
            <translation>Заданная скорость, °/s</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Mount:angle</source>
            <translation>Установка:угол</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>Record</source>
            <translation>Запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>No samples: choose a device, or load a record</source>
            <translation>Нет отсчётов: выберите устройство или загрузите запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Watching, not recorded</source>
            <translation>Наблюдение, не записывается</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Recording {name}</source>
            <translation>Записывается {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Stopped: {name}</source>
            <translation>Остановлено: {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Record {name}</source>
            <translation>Запись {name}</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>No device sends samples, or their rate is not known yet</source>
            <translation>Ни одно устройство не передаёт отсчётов, или их частота ещё неизвестна</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>START sampling process</source>
            <translation>Начать запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>STOP sampling process</source>
            <translation>Остановить запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>A record is running</source>
            <translation>Идёт запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>No record is stopped</source>
            <translation>Ни одна запись не остановлена</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Resume</source>
            <translation>Продолжить</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Discard</source>
            <translation>Отбросить</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Live view</source>
            <translation>Живой вид</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>The live view is on the screen</source>
            <translation>Живой вид уже на экране</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Load record</source>
            <translation>Загрузить запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Nothing is on the screen</source>
            <translation>На экране ничего нет</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>Record stopped</source>
            <translation>Запись остановлена</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>{name}: {count} samples, {seconds} s, safe on the disk.</source>
            <translation>{name}: {count} [отсчёт|отсчёта|отсчётов], {seconds} s, надёжно на диске.</translation>
        </message>
        <message>
            <location filename="../../gui/live/scene.py" />
            <source>START begins another one.</source>
            <translation>START начинает следующую.</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>The disk lasts {time} more</source>
            <translation>Диска хватит ещё на {time}</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{folder} has little room left for the record.</source>
            <translation>{folder}: мало места для записи.</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>Free some space; what is written stays readable when it runs out.</source>
            <translation>Освободите место; записанное остаётся читаемым, когда оно кончится.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Accumulates by itself once the table turns steadily.</source>
            <translation>Накапливает сам, когда стол вращается равномерно.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>The rate is changing.</source>
            <translation>Скорость меняется.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>The table turns steadily; hands off.</source>
            <translation>Стол вращается равномерно; не трогайте.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Leave the table alone.</source>
            <translation>Не трогайте стол.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>The rate changed</source>
            <translation>Скорость изменилась</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Wrong rate</source>
            <translation>Неверная скорость</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Rates</source>
            <translation>Скорости</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Stop the table</source>
            <translation>Остановите стол</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Turn at {rate}</source>
            <translation>Задайте {rate}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>Stop the table and bolt the unit on with {up}. </source>
            <translation>Остановите стол и закрепите изделие: {up}. </translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>counter-clockwise seen from above</source>
            <translation>против часовой, если сверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>clockwise seen from above</source>
            <translation>по часовой, если сверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>{seconds} s (whole turns: {turns})</source>
            <translation>{seconds} s (целых оборотов: {turns})</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/words.py" />
            <source>{seconds} s ({turns} turns; {whole} s would be whole turns)</source>
            <translation>{seconds} s ({turns} [оборот|оборота|оборотов]; целыми были бы {whole} s)</translation>
        </message>
        <message>
            <location filename="../../gui/report_export.py" />
            <source>Tables, CSV</source>
            <translation>Таблицы, CSV</translation>
        </message>
        <message>
            <location filename="../../gui/report_export.py" />
            <source>Picture, {suffix}</source>
            <translation>Рисунок, {suffix}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Nothing found</source>
            <translation>Ничего не найдено</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>{rows} positions, {device}</source>
            <translation>положений: {rows}, {device}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>, {low} … {high}; beyond, nothing is compensated</source>
            <translation>, {low} … {high}; вне этого ничего не компенсируется</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Six positions and temperature</source>
            <translation>Шесть положений и температура</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Parameters over temperature</source>
            <translation>Параметры по температуре</translation>
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
            <translation>Гистерезис: нагрев минус охлаждение, 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>What no function of the temperature can compensate.</source>
            <translation>Чего не скомпенсирует никакая функция температуры.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>U0 / k</source>
            <translation>U0 / k</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Orders, rms at temperatures left out</source>
            <translation>Порядки, СКО при исключённых температурах</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>The lowest that leave at most 10 % more than the best are taken.</source>
            <translation>Берётся наименьший, который оставляет не более чем на 10 % больше лучшего.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>took part</source>
            <translation>участвовал</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>all</source>
            <translation>все</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Rows of the check run, which took no part.</source>
            <translation>Строки проверочной серии, которая не участвовала.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Each temperature but the outermost is left out in turn and compensated by the others.</source>
            <translation>Каждая температура, кроме крайних, по очереди исключена и скомпенсирована по остальным.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Largest error of roll or pitch, °</source>
            <translation>Наибольшая погрешность крена или тангажа, °</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>compensated</source>
            <translation>скомпенсировано</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Errors of roll and pitch, °</source>
            <translation>Погрешности крена и тангажа, °</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Roll is not defined where the Y axis is vertical.</source>
            <translation>Крен не определён там, где ось Y вертикальна.</translation>
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
            <translation>крен после</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>pitch after</source>
            <translation>тангаж после</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>left, {axis}</source>
            <translation>остаток, {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Six positions</source>
            <translation>Шесть положений</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>Six positions at {t}</source>
            <translation>Шесть положений при {t}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>{law}: scale factors, angles of T, mounting. Nine: source 002 has no R.</source>
            <translation>{law}: масштабные коэффициенты, углы T, установка. Девять: у источника 002 нет R.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>twelve</source>
            <translation>двенадцать</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>nine</source>
            <translation>девять</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>left, twelve</source>
            <translation>остаток, двенадцать</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>left, nine</source>
            <translation>остаток, девять</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>The same at each temperature</source>
            <translation>То же при каждой температуре</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/findings.py" />
            <source>↑ reached by heating, ↓ by cooling.</source>
            <translation>↑ достигнуто нагревом, ↓ охлаждением.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>polynomial</source>
            <translation>полином</translation>
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
            <translation>{title};  гистерезис {value} {unit} при {at}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>heated</source>
            <translation>нагрев</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>cooled</source>
            <translation>охлаждение</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>by the first temperature</source>
            <translation>по первой температуре</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>error, °</source>
            <translation>погрешность, °</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>heating</source>
            <translation>нагрев</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/pictures.py" />
            <source>cooling</source>
            <translation>охлаждение</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Outputs</source>
            <translation>Выходы</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>There is no cycle yet</source>
            <translation>Цикла ещё нет</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>In {root} no session of the dividing head went through temperatures.</source>
            <translation>В {root} ни один сеанс делительной головки не проходил температур.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Measure one there (Temperatures), or add its files here.</source>
            <translation>Измерьте его там (Температуры) или добавьте его файлы здесь.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>The last cycle was not found</source>
            <translation>Последний цикл не найден</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>{name} cannot be used</source>
            <translation>{name} невозможно использовать</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Remove it from the list; the others are used without it.</source>
            <translation>Уберите его из списка; остальные используются без него.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Simulated cycle</source>
            <translation>Симуляция</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>{rows} rows</source>
            <translation>строк: {rows}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>check only</source>
            <translation>только проверка</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Last Cycle</source>
            <translation>Последний цикл</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Add Files</source>
            <translation>Добавить файлы</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Check only</source>
            <translation>Только проверка</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Let take part</source>
            <translation>Разрешить участие</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>The files are being read …</source>
            <translation>Файлы читаются …</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>There is nothing to draw over the temperature; see the notes.</source>
            <translation>По температуре рисовать нечего; см. замечания.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/presenter.py" />
            <source>Last Cycle (Space) takes the newest session that the dividing head measured through its Temperatures (+27 −10 −40 −10 +27 +50 +70 +50 +27 °C).

Add Files or Add Folder takes sessions, run files and ClbAcc's text files as one set, or the record of a unit that stood in the chamber.

Simulated cycle (F6) shows the tab on a made-up unit.</source>
            <translation>«Последний цикл» (Space) берёт новейший сеанс, который делительная головка измерила через свои температуры (+27 −10 −40 −10 +27 +50 +70 +50 +27 °C).

«Добавить файлы» или «Добавить папку» берёт сеансы, файлы серий и текстовые файлы ClbAcc как один набор или запись изделия, стоявшего в камере.

«Симуляция» (F6) показывает вкладку на вымышленном изделии.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>{rows} rows, {device}, {low} … {high}; beyond, nothing is compensated</source>
            <translation>{rows} [строка|строки|строк], {device}, {low} … {high}; вне этого ничего не компенсируется</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>A standing unit over temperature</source>
            <translation>Неподвижное изделие по температуре</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>Before and after, {unit}</source>
            <translation>До и после, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>Heating less cooling where they differ most, 95 %.</source>
            <translation>Нагрев минус охлаждение там, где они различаются сильнее всего, 95 %.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>output</source>
            <translation>выход</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>order</source>
            <translation>порядок</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>sd before</source>
            <translation>СКО до</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>hysteresis</source>
            <translation>гистерезис</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>Polynomials</source>
            <translation>Полиномы</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/record_findings.py" />
            <source>coefficient</source>
            <translation>коэффициент</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/texts.py" />
            <source>Bias</source>
            <translation>Нулевой сигнал</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/texts.py" />
            <source>Scale factor</source>
            <translation>Масштаб. коэф.</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/texts.py" />
            <source>Errors of roll and pitch</source>
            <translation>Погрешности крена и тангажа</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The device</source>
            <translation>Устройство</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>A simulated sensor unit is connected; a real one is found by Properties, Scan. This line tells whether samples come, how fast, and whether any are bad or lost.</source>
            <translation>Подключён симулированный блок датчиков; настоящий находят через «Свойства», «Поиск». Эта строка говорит, поступают ли отсчёты, как быстро, и есть ли плохие или потерянные.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The plan</source>
            <translation>План</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Every position that this test wants, with its picture. The marked one is next; a click, a digit, or the arrows and Enter pick another.</source>
            <translation>Каждое положение, нужное этому испытанию, с рисунком. Отмеченное — следующее; щелчок, цифра или стрелки и Enter выбирают другое.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>What to do now</source>
            <translation>Что делать сейчас</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The order of the moment in large letters: turn, wait, measuring, done. F11 gives it the whole screen, so that it is read from the dividing head.</source>
            <translation>Приказ момента крупными буквами: повернуть, ждать, измерение, готово. F11 отдаёт ему весь экран, чтобы читать от делительной головки.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The simulated rig</source>
            <translation>Симулированный стенд</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Drag the hand of the dial, or let Operator turns it for me do it. Faults can be tried as well: unplug the cable, and see that nothing is lost.</source>
            <translation>Потяните стрелку лимба или дайте «Поворачивает оператор» сделать это. Можно испытать и неисправности: отключите кабель и увидите, что ничего не потеряно.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Measuring</source>
            <translation>Измеряю</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Space accumulates, here and in every tab. Backspace repeats the last position, Ctrl+Z takes it back, Esc stops. Switch Hands-free on, and a turned and resting head is enough. At the end Process Data (F5), then Export.</source>
            <translation>Space накапливает, здесь и в каждой вкладке. Backspace повторяет последнее положение, Ctrl+Z отменяет его, Esc останавливает. Включите «Без рук», и достаточно повернуть головку и подождать. В конце «Обработать данные» (F5), затем «Экспорт».</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Settings of the test</source>
            <translation>Настройки испытания</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Times, local gravity and its uncertainty, uncertainty of the head. What holds for the whole laboratory stands in Preferences (Ctrl+,).</source>
            <translation>Времена, местное g и его неопределённость, неопределённость головки. То, что общее для лаборатории, — в «Настройках» (Ctrl+,).</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>The other tabs</source>
            <translation>Другие вкладки</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Gyros on the rate table, a check of the accuracy, live charts, noise, thermal tests, drift tables; Archive finds everything again by serial number. Ctrl and a digit open a tab.</source>
            <translation>Гироскопы на поворотном столе, проверка точности, живые графики, шум, температурные испытания, таблицы дрейфа; «Архив» находит всё по заводскому номеру. Ctrl и цифра открывают вкладку.</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Menu and help</source>
            <translation>Меню и справка</translation>
        </message>
        <message>
            <location filename="../../gui/tour/steps.py" />
            <source>Light or dark, sounds, preferences, and this tour again. F1 shows all keys. That is all: press Space at any position, and the first calibration begins.</source>
            <translation>Светлый или тёмный вид, звуки, настройки и этот обзор снова. F1 показывает все клавиши. Это всё: нажмите Space в любом положении, и первая калибровка начнётся.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Well determined (14)</source>
            <translation>Хорошо определённые (14)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>U0, with K2·g²/2</source>
            <translation>U0, вместе с K2·g²/2</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Sensitivity</source>
            <translation>Чувствительность</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Misalignment, whole</source>
            <translation>Несоосность, общая</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Split (18), if K2 = 0</source>
            <translation>Разложение (18), если K2 = 0</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>from</source>
            <translation>от</translation>
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
            <translation>Датчик в корпусе</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>k across</source>
            <translation>k поперёк</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Fixture and sensor apart</source>
            <translation>Оснастка и датчик порознь</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Half sum and half difference of the two mounts; nothing is assumed of K2</source>
            <translation>Полусумма и полуразность двух установок; о K2 ничего не предполагается</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>{pairs} angles twice</source>
            <translation>углов дважды: {pairs}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Drift over a full turn</source>
            <translation>Дрейф за полный оборот</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Angles that came again, e.g. 5° and 365°</source>
            <translation>Углы, которые повторились, напр. 5° и 365°</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>Test turns (4), (5), (8), (11)</source>
            <translation>Испытательные обороты (4), (5), (8), (11)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/pictures.py" />
            <source>pass {number}</source>
            <translation>проход {number}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>This run is no tumble that can be used</source>
            <translation>Эта серия не является пригодным оборотом</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>{file}: {readings} readings at {angles} angles, {mounts}</source>
            <translation>{file}: {readings} [показание|показания|показаний] на {angles} углах, {mounts}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>One accelerometer through a full turn of the dividing head.

Measure the plan fourier_400 (5° to 400° by 5°) or fourier_flip in the tab Dividing head, then press Measured Session (Space); or Load Data (Ctrl+O): a session, a run file, a text file of ClbAcc or Pointer.</source>
            <translation>Один акселерометр через полный оборот делительной головки.

Измерьте план fourier_400 (от 5° до 400° через 5°) или fourier_flip во вкладке «Делительная головка», затем нажмите «Измеренный сеанс» (Space); или «Загрузить данные» (Ctrl+O): сеанс, файл серии, текстовый файл ClbAcc или Pointer.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>Measured Session</source>
            <translation>Измеренный сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Stop</source>
            <translation>Остановить</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Accumulate Data</source>
            <translation>Накопить данные</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Repeat</source>
            <translation>Повторить</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>Process Data</source>
            <translation>Обработать данные</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/table_picture.py" />
            <source>the table stands</source>
            <translation>стол стоит</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/table_picture.py" />
            <source>{axis} down</source>
            <translation>{axis} вниз</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/table_picture.py" />
            <source>{axis} up</source>
            <translation>{axis} вверх</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/checking.py" />
            <source>{name} holds the test {test}, no accuracy check</source>
            <translation>{name} содержит испытание {test}, а не проверку точности</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/checking.py" />
            <source>{name} is not used: {error}</source>
            <translation>{name} не использовано: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/checking.py" />
            <source>the archive was not asked for the nearest calibration: {error}</source>
            <translation>архив не запрошен о ближайшей калибровке: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/demo.py" />
            <source>Accuracy</source>
            <translation>Точность</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/demo.py" />
            <source>the rig did not answer</source>
            <translation>стенд не ответил</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/demo.py" />
            <source>the angles were not judged</source>
            <translation>углы не оценены</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/offering.py" />
            <source>accuracy calibration</source>
            <translation>калибровка для проверки точности</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/results.py" />
            <source>the verdict was not kept: {error}</source>
            <translation>решение не сохранено: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tab.py" />
            <source>accuracy angles</source>
            <translation>accuracy angles</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Min</source>
            <translation>Мин.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Max</source>
            <translation>Макс.</translation>
        </message>
        <message>
            <location filename="../../gui/accuracy/tables.py" />
            <source>Noise STD</source>
            <translation>СКО шума</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/findings.py" />
            <source>a plan without a prediction has no table</source>
            <translation>у плана без предсказания нет таблицы</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/page.py" />
            <source>Prediction {plan_id}</source>
            <translation>Предсказание {plan_id}</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/presenter.py" />
            <source>Space</source>
            <translation>Space</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>dividing head</source>
            <translation>делительная головка</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>rate table</source>
            <translation>поворотный стол</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>climate chamber</source>
            <translation>термокамера</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/side_view.py" />
            <source>level base</source>
            <translation>горизонтальное основание</translation>
        </message>
        <message>
            <location filename="../../gui/advisor/words.py" />
            <source>noise with memory</source>
            <translation>шум с памятью</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>noise of a record at rest: likelihood of its spectrum and Allan deviation, terms of IEEE Std 952 and IEEE Std 1431, practicum (6.3), (6.4)</source>
            <translation>шум записи в покое: правдоподобие спектра и девиация Аллана, термины IEEE Std 952 и IEEE Std 1431, практикум (6.3), (6.4)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>angle random walk</source>
            <translation>случайное блуждание угла</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>bias instability</source>
            <translation>нестабильность нуля</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>rate random walk</source>
            <translation>случайное блуждание скорости</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>rate ramp</source>
            <translation>линейный уход скорости</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>angle quantization</source>
            <translation>квантование угла</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>velocity random walk</source>
            <translation>случайное блуждание скорости</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>acceleration random walk</source>
            <translation>случайное блуждание ускорения</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>acceleration ramp</source>
            <translation>линейный уход ускорения</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>velocity quantization</source>
            <translation>квантование скорости</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>Noise coefficients, 95 %</source>
            <translation>Коэффициенты шума, 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>Allan deviation with its 95 % limits</source>
            <translation>Девиация Аллана с пределами 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>averaging time τ, s</source>
            <translation>время усреднения τ, s</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>no term was fitted</source>
            <translation>ни один член не определён</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>{name}: its noise cannot be certified: {why}</source>
            <translation>{name}: шум нельзя засвидетельствовать: {why}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>term (IEEE 952, IEEE 1431)</source>
            <translation>термин (IEEE 952, IEEE 1431)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>stated as</source>
            <translation>представлено как</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>from … to</source>
            <translation>от … до</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>fitted model</source>
            <translation>оценённая модель</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>length of the record</source>
            <translation>длительность записи</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>sampling rate</source>
            <translation>частота выборки</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>highest frequency fitted</source>
            <translation>наивысшая аппроксимируемая частота</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>scale factor</source>
            <translation>масштабный коэффициент</translation>
        </message>
        <message>
            <location filename="../../gui/allan/certified.py" />
            <source>cannot be read: {strerror}</source>
            <translation>невозможно прочитать: {strerror}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>Allan</source>
            <translation>Аллан</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>the plot did not come</source>
            <translation>график не появился</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>a record was not analysed</source>
            <translation>запись не проанализирована</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>there are no records to analyse</source>
            <translation>нет записей для анализа</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>play the part live first</source>
            <translation>сначала проиграйте часть live</translation>
        </message>
        <message>
            <location filename="../../gui/allan/demo.py" />
            <source>{name} was not written</source>
            <translation>{name} не записано</translation>
        </message>
        <message>
            <location filename="../../gui/allan/exporting.py" />
            <source>no analysed record is shown; analyse a record first</source>
            <translation>проанализированная запись не показана; сначала проанализируйте запись</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>σ²(τ) = R²τ²/2 + K²τ/3 + B²·(2/π) ln 2 + N²/τ + 3Q²/τ²   (6.4)</source>
            <translation>σ²(τ) = R²τ²/2 + K²τ/3 + B²·(2/π) ln 2 + N²/τ + 3Q²/τ²   (6.4)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Whittle</source>
            <translation>Уиттл</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>least squares</source>
            <translation>наименьшие квадраты</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>{grouped} samples at {rate} Hz, {duration}, in {plain_unit}</source>
            <translation>{grouped} [отсчёт|отсчёта|отсчётов] при {rate} Hz, {duration}, в {plain_unit}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>{grouped} samples at {rate} Hz, {duration}</source>
            <translation>{grouped} [отсчёт|отсчёта|отсчётов] при {rate} Hz, {duration}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Whittle: likelihood of the spectrum, published. Least squares of σ²(τ): independent opinion. Graphical: the practicum's reading; it always finds a B.</source>
            <translation>Уиттл: правдоподобие спектра, публикуется. Наименьшие квадраты σ²(τ): независимое мнение. Графически: способ практикума; он всегда находит B.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Weighted with the noise that is left; powers of the channel less its mean ({means}).</source>
            <translation>С весами по оставшемуся шуму; степени канала минус его среднее ({means}).</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>cannot be used</source>
            <translation>невозможно использовать</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>{device} {name}, live</source>
            <translation>{device} {name}, вживую</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Comparison of the devices (lab 6)</source>
            <translation>Сравнение устройств (лабораторная 6)</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>By method</source>
            <translation>По методам</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Limits of one sigma; no terms are fitted to it.</source>
            <translation>Пределы одной сигмы; составляющие по ним не оценивают.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Before and after the regression</source>
            <translation>До и после регрессии</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Regression</source>
            <translation>Регрессия</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>What a longer record would give</source>
            <translation>Что дала бы более длинная запись</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>Relative standard uncertainties; the smallest B is found four times in five.</source>
            <translation>Относительные стандартные неопределённости; наименьшее B находят в четырёх случаях из пяти.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>there is no regression</source>
            <translation>регрессии нет</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>smallest B, {plain_unit}</source>
            <translation>наименьшее B, {plain_unit}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/findings.py" />
            <source>not found</source>
            <translation>не найдено</translation>
        </message>
        <message>
            <location filename="../../gui/allan/live.py" />
            <source>waiting for samples</source>
            <translation>ожидание отсчётов</translation>
        </message>
        <message>
            <location filename="../../gui/allan/live.py" />
            <source>the sample rate is being measured</source>
            <translation>измеряется частота отсчётов</translation>
        </message>
        <message>
            <location filename="../../gui/allan/picture.py" />
            <source>{name}, before regression</source>
            <translation>{name}, до регрессии</translation>
        </message>
        <message>
            <location filename="../../gui/allan/picture.py" />
            <source>{name}, after</source>
            <translation>{name}, после</translation>
        </message>
        <message>
            <location filename="../../gui/allan/plot_view.py" />
            <source>, slope {slopes}</source>
            <translation>, наклон {slopes}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>No device is connected: open Properties at the top.</source>
            <translation>Устройство не подключено: откройте «Свойства» вверху.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Add Records (Ctrl+O) reads records of a sensor at rest: recordings, files of CVGCom, run files, columns of numbers. An hour at 100 Hz is a good beginning.

Live curve (Space) draws the curve of the connected device while it runs.</source>
            <translation>«Добавить записи» (Ctrl+O) читает записи датчика в покое: записи программы, файлы CVGCom, файлы серий, столбцы чисел. Час при 100 Hz — хорошее начало.

«Живая кривая» (Space) рисует кривую подключённого устройства во время его работы.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>is being analysed …</source>
            <translation>анализируется …</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>The live curve begins in some seconds: {why}.</source>
            <translation>Живая кривая начнётся через несколько секунд: {why}.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>The record is being read and analysed …</source>
            <translation>Запись читается и анализируется …</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>{grouped} samples</source>
            <translation>{grouped} [отсчёт|отсчёта|отсчётов]</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>growing: {detail}</source>
            <translation>растёт: {detail}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>{duration} at {rate} Hz, {unit}</source>
            <translation>{duration} at {rate} Hz, {unit}</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Stop live curve</source>
            <translation>Остановить живую кривую</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Esc</source>
            <translation>Esc</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Live curve</source>
            <translation>Живая кривая</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Add Records</source>
            <translation>Добавить записи</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Analyse Recording</source>
            <translation>Анализ записи</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>No live curve was begun.</source>
            <translation>Живая кривая не начата.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Delete</source>
            <translation>Delete</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>{name} cannot be analysed</source>
            <translation>{name} невозможно проанализировать</translation>
        </message>
        <message>
            <location filename="../../gui/allan/presenter.py" />
            <source>Set its channel and rate at the left, or remove it from the list.</source>
            <translation>Укажите его канал и частоту слева или уберите его из списка.</translation>
        </message>
        <message>
            <location filename="../../gui/allan/settings_view.py" />
            <source>{rate} Hz</source>
            <translation>{rate} Hz</translation>
        </message>
        <message>
            <location filename="../../gui/allan/tab.py" />
            <source>Allan deviation</source>
            <translation>Девиация Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/allan/tab.py" />
            <source>{path}: there is no plot yet</source>
            <translation>{path}: графика ещё нет</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>Hadamard deviation</source>
            <translation>Девиация Адамара</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>Modified Allan deviation</source>
            <translation>Модифицированная девиация Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>Total deviation</source>
            <translation>Полная девиация</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>random walk, two-sided S = N^2</source>
            <translation>случайное блуждание, двустороннее S = N^2</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>noise density, one-sided</source>
            <translation>плотность шума, односторонняя</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>flicker coefficient B</source>
            <translation>коэффициент фликкера B</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>floor of the Allan curve, 0.664 B</source>
            <translation>дно кривой Аллана, 0,664 B</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>random walk, two-sided</source>
            <translation>случайное блуждание, двустороннее</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>flicker coefficient</source>
            <translation>коэффициент фликкера</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>floor of the curve, 0.664 B</source>
            <translation>дно кривой, 0,664 B</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>N  two-sided</source>
            <translation>N  двусторонняя</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>√2 N  one-sided</source>
            <translation>√2 N  односторонняя</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>B  flicker</source>
            <translation>B  фликкер</translation>
        </message>
        <message>
            <location filename="../../gui/allan/texts.py" />
            <source>0.664 B  floor</source>
            <translation>0,664 B  дно</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Live</source>
            <translation>Вживую</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Thermal</source>
            <translation>Термо</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Methods</source>
            <translation>Методы</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Model vs data</source>
            <translation>Модель и данные</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Archive</source>
            <translation>Архив</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Teach a board</source>
            <translation>Обучить плату</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Certificates</source>
            <translation>Сертификаты</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>No device is connected</source>
            <translation>Устройство не подключено</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Choose the port of the unit in Device Properties; or try the program on its simulated rig, which speaks the same protocols.</source>
            <translation>Выберите порт изделия в «Свойствах устройств» или испытайте программу на симулированном стенде, который говорит теми же протоколами.</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Start with pointer, clbacc, or a whole sim:// address.</source>
            <translation>Начните с pointer, clbacc или полного адреса sim://.</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Simulated PW09</source>
            <translation>Симулированный PW09</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>Simulated assembly</source>
            <translation>Симулированная сборка</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>No such rig</source>
            <translation>Такого стенда нет</translation>
        </message>
        <message>
            <location filename="../../gui/app.py" />
            <source>A device file is refused</source>
            <translation>Файл устройства отклонён</translation>
        </message>
        <message>
            <location filename="../../gui/archive/demo.py" />
            <source>the archive did not list all</source>
            <translation>архив показал не всё</translation>
        </message>
        <message>
            <location filename="../../gui/archive/demo.py" />
            <source>the archive did not answer</source>
            <translation>архив не ответил</translation>
        </message>
        <message>
            <location filename="../../gui/archive/library.py" />
            <source>the window was closed; what was taken in stays</source>
            <translation>окно закрыто; то, что взято, остаётся</translation>
        </message>
        <message>
            <location filename="../../gui/archive/questions.py" />
            <source>is no session: it has no raw bytes</source>
            <translation>не сеанс: у него нет необработанных байтов</translation>
        </message>
        <message>
            <location filename="../../gui/archive/raw.py" />
            <source>{path}: profile</source>
            <translation>{path}: профиль</translation>
        </message>
        <message>
            <location filename="../../gui/archive/raw.py" />
            <source>holds no device file by which its bytes could be read</source>
            <translation>не содержит файла устройства, по которому можно прочитать его байты</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>{marked} of {len} differ by more than 2 u</source>
            <translation>{marked} из {len} отличаются более чем на 2 u</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>not counted</source>
            <translation>не учтено</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>drift, not significant</source>
            <translation>дрейф, незначимый</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>not possible</source>
            <translation>невозможно</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>the same</source>
            <translation>то же самое</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>repeatability s</source>
            <translation>повторяемость s</translation>
        </message>
        <message>
            <location filename="../../gui/archive/texts.py" />
            <source>s beyond the u</source>
            <translation>s сверх u</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>The last bytes are not recorded</source>
            <translation>Последние байты не записаны</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>No link</source>
            <translation>Нет связи</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>raw log</source>
            <translation>необработанный журнал</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>Bytes are not recorded</source>
            <translation>Байты не записываются</translation>
        </message>
        <message>
            <location filename="../../gui/devices/connection.py" />
            <source>The port stays busy</source>
            <translation>Порт остаётся занятым</translation>
        </message>
        <message>
            <location filename="../../gui/devices/link.py" />
            <source>{folder}: cannot be made ({strerror})</source>
            <translation>{folder}: невозможно создать ({strerror})</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>The ports cannot be looked at</source>
            <translation>Порты невозможно просмотреть</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Listening</source>
            <translation>Прослушивание</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Asking at</source>
            <translation>Запрос на</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Listening at</source>
            <translation>Прослушивание на</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>A device file is wrong</source>
            <translation>Файл устройства неверен</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>Choose a port first.</source>
            <translation>Сначала выберите порт.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/presenter.py" />
            <source>{verb} {url}, {baud} baud</source>
            <translation>{verb} {url}, {baud} baud</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{url}: nothing came at any baud rate.</source>
            <translation>{url}: ни на одной скорости ничего не пришло.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{url}: bytes came that no device file explains.</source>
            <translation>{url}: пришли байты, которых не объясняет ни один файл устройства.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>Ask for the names at {join}? The unit is stopped, asked and started again.</source>
            <translation>Запросить имена на {join}? Изделие будет остановлено, опрошено и запущено снова.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>Ask at {join}? Identify commands of all known devices are sent; agree only if nothing else is connected there.</source>
            <translation>Запросить на {join}? Будут переданы команды распознавания всех известных устройств; соглашайтесь, только если там не подключено ничего другого.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>The ports are in use</source>
            <translation>Порты используются</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>Stop the accumulation first.</source>
            <translation>Сначала остановите накопление.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{frames} frames</source>
            <translation>кадров: {frames}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>it answered</source>
            <translation>ответил</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>{url}: {name}, {baud} baud ({heard}).</source>
            <translation>{url}: {name}, {baud} baud ({heard}).</translation>
        </message>
        <message>
            <location filename="../../gui/devices/scan_words.py" />
            <source>It could also be {name}.</source>
            <translation>Это может быть также {name}.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/state.py" />
            <source>The scan goes on</source>
            <translation>Поиск продолжается</translation>
        </message>
        <message>
            <location filename="../../gui/devices/state.py" />
            <source>Choose a port for every device</source>
            <translation>Выберите порт для каждого устройства</translation>
        </message>
        <message>
            <location filename="../../gui/devices/state.py" />
            <source>Two devices have the same port</source>
            <translation>У двух устройств один и тот же порт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Port Name</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>Device file</source>
            <translation>Файл устройства</translation>
        </message>
        <message>
            <location filename="../../gui/devices/view.py" />
            <source>found by Scan</source>
            <translation>найдено поиском</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Try again</source>
            <translation>Попробовать снова</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The program stood still for {float} s, as when the computer sleeps. What the port could not hold meanwhile is lost: a device with a counter tells how much, the record of another one runs on as if no time had passed.</source>
            <translation>Программа стояла {float} s, как когда компьютер спит. То, чего порт за это время не вместил, потеряно: устройство со счётчиком говорит сколько, а запись другого идёт, как если бы время не прошло.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Nothing comes from {url}</source>
            <translation>От {url} ничего не поступает</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The port is open, and no byte has arrived.</source>
            <translation>Порт открыт, но не пришло ни одного байта.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Check the supply of the unit and the cable, or choose another port.</source>
            <translation>Проверьте питание изделия и кабель или выберите другой порт.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Link lost: {partition}</source>
            <translation>Связь потеряна: {partition}</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>{name}: {why}. Everything accepted so far is on the disk.</source>
            <translation>{name}: {why}. Всё принятое до сих пор уже на диске.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Plug the adapter in again; the program reconnects by itself and goes on.</source>
            <translation>Подключите адаптер снова; программа сама восстановит связь и продолжит.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>{name} has stopped sending</source>
            <translation>{name} перестал передавать</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The port {url} is open, but no frame has come for {silent_s} s.</source>
            <translation>Порт {url} открыт, но кадров нет уже {silent_s} s.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Check the supply of the unit; measuring goes on by itself when frames come.</source>
            <translation>Проверьте питание изделия; измерение продолжится само, когда придут кадры.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>Nothing that comes from {url} can be read</source>
            <translation>То, что поступает от {url}, прочитать невозможно</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>{bytes} bytes have come, and no frame of the profile was among them.</source>
            <translation>Пришло {bytes} [байт|байта|байтов], и среди них нет ни одного кадра профиля.</translation>
        </message>
        <message>
            <location filename="../../gui/devices/words.py" />
            <source>The baud rate or the profile is wrong: scan the port.</source>
            <translation>Скорость или профиль неверны: запустите поиск на порту.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/cards.py" />
            <source>; tells apart</source>
            <translation>; различает</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the session was not calibrated</source>
            <translation>сеанс не откалиброван</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>nothing was found</source>
            <translation>ничего не найдено</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the search did not end</source>
            <translation>поиск не завершился</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the effect was not added</source>
            <translation>эффект не добавлен</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the rig did not walk the rows</source>
            <translation>стенд не прошёл строки</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>the calibration did not take the effect</source>
            <translation>калибровка не приняла эффект</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>Mixed angles, twice</source>
            <translation>Углы вперемешку, дважды</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/demo.py" />
            <source>model vs data</source>
            <translation>модель и данные</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/exporting.py" />
            <source>discrepancy export</source>
            <translation>discrepancy export</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>discrepancy plan</source>
            <translation>план по расхождению</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/follow_up.py" />
            <source>{folder}: a thousand plans are named {stem}; take some away</source>
            <translation>{folder}: тысяча планов названа {stem}; уберите часть</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/record_steps.py" />
            <source>a record is explained as a whole: {effect} was not found beside the other effects, and only what was found is added to it</source>
            <translation>запись объясняется целиком: {effect} рядом с другими эффектами не найден, а добавляется к ней только найденное</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/scene.py" />
            <source>sensor {name}</source>
            <translation>датчик {name}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial.py" />
            <source>case {seed}</source>
            <translation>случай {seed}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_presenter.py" />
            <source>blind trial</source>
            <translation>слепое испытание</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_record.py" />
            <source>Blind trial</source>
            <translation>Слепое испытание</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_record.py" />
            <source>Rate</source>
            <translation>Частота</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/working.py" />
            <source>a record is compared by itself: open one file at a time</source>
            <translation>запись сравнивается сама по себе: открывайте по одному файлу</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/formats.py" />
            <source>Run file of the positions</source>
            <translation>Файл серии с положениями</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/guide.py" />
            <source>No accelerometers</source>
            <translation>Нет акселерометров</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/guide.py" />
            <source>{name} sends none, so that it cannot be measured here. Choose another device.</source>
            <translation>{name} их не передаёт, поэтому здесь его не измерить. Выберите другое устройство.</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>{name} holds a {sensor} in the test {test}; here are accelerometers on the dividing head</source>
            <translation>{name} содержит {sensor} в испытании {test}; здесь акселерометры на делительной головке</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>the calibration was not kept: {error}</source>
            <translation>калибровка не сохранена: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>{name} is an accuracy check: load or measure the calibration of the triad first, then load this file</source>
            <translation>{name} — проверка точности: сначала загрузите или измерьте калибровку триады, затем загрузите этот файл</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/processing.py" />
            <source>{device}, {len} positions</source>
            <translation>{device}, положений: {len}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings.py" />
            <source>None</source>
            <translation>Нет</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings.py" />
            <source>Auto</source>
            <translation>Авто</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings.py" />
            <source>Manual</source>
            <translation>Вручную</translation>
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
            <translation>Ориентация основания {name}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/settings_view.py" />
            <source>Tilter {name}</source>
            <translation>Наклонитель {name}</translation>
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
            <translation>Параметры (таблица {triad})</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Derived quantities</source>
            <translation>Производные величины</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Measured outputs and residuals, {unit} (Table {is_triad})</source>
            <translation>Измеренные выходы и остатки, {unit} (таблица {is_triad})</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Attitude check, deg</source>
            <translation>Проверка ориентации, deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Accuracy (Tables 2.5, 2.6): m/s² and deg</source>
            <translation>Точность (таблицы 2.5, 2.6): m/s² и deg</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Sensor</source>
            <translation>Датчик</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Mount</source>
            <translation>Установка</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Head</source>
            <translation>Головка</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Pitch set</source>
            <translation>Тангаж заданный</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Roll set</source>
            <translation>Крен заданный</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Row</source>
            <translation>Строка</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>unit's own</source>
            <translation>собственные изделия</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Misalignment towards {axis}</source>
            <translation>Несоосность к {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Triad</source>
            <translation>Триада</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Non-orthogonality {pair}</source>
            <translation>Неортогональность {pair}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/tables.py" />
            <source>Mounting about {axis}</source>
            <translation>Установка вокруг {axis}</translation>
        </message>
        <message>
            <location filename="../../gui/dividing_head/thermal_offer.py" />
            <source>dividing_head thermal</source>
            <translation>dividing_head thermal</translation>
        </message>
        <message>
            <location filename="../../gui/drift/demo.py" />
            <source>no table was made</source>
            <translation>таблица не создана</translation>
        </message>
        <message>
            <location filename="../../gui/drift/exporting.py" />
            <source>drift after switching on, source 003</source>
            <translation>дрейф после включения, источник 003</translation>
        </message>
        <message>
            <location filename="../../gui/drift/library.py" />
            <source>turn-ons in {join}; one unit is needed</source>
            <translation>включения в {join}; нужна одна единица</translation>
        </message>
        <message>
            <location filename="../../gui/drift/library.py" />
            <source>cannot be read: {error}</source>
            <translation>невозможно прочитать: {error}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/library.py" />
            <source>{memory} bytes hold no table of {temperatures} temperatures; two knots need {temperatures2}</source>
            <translation>{memory} [байт|байта|байтов] не вмещают таблицы для {temperatures} [температуры|температур|температур]; двум узлам нужно {temperatures2}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/reading.py" />
            <source>{path}: holds a test {test}, no record since switching on</source>
            <translation>{path}: содержит испытание {test}, а не запись от включения</translation>
        </message>
        <message>
            <location filename="../../gui/drift/reading.py" />
            <source>{path}: no output {channel}; there are: {join}</source>
            <translation>{path}: нет выхода {channel}; есть: {join}</translation>
        </message>
        <message>
            <location filename="../../gui/drift/tab.py" />
            <source>Drift after switching on</source>
            <translation>Дрейф после включения</translation>
        </message>
        <message>
            <location filename="../../gui/exporting.py" />
            <source>Not exported</source>
            <translation>Не экспортировано</translation>
        </message>
        <message>
            <location filename="../../gui/exporting.py" />
            <source>Exported</source>
            <translation>Экспортировано</translation>
        </message>
        <message>
            <location filename="../../gui/frames/definition_view.py" />
            <source>Saved: {saved}</source>
            <translation>Сохранено: {saved}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>the layout was not found</source>
            <translation>строение не найдено</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>Invented board</source>
            <translation>Вымышленная плата</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>the device file could not be saved</source>
            <translation>файл устройства не удалось сохранить</translation>
        </message>
        <message>
            <location filename="../../gui/frames/demo.py" />
            <source>invented board</source>
            <translation>вымышленная плата</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>{hint}, no channel</source>
            <translation>{hint}, не канал</translation>
        </message>
        <message>
            <location filename="../../gui/frames/listening.py" />
            <source>unknown board</source>
            <translation>неизвестная плата</translation>
        </message>
        <message>
            <location filename="../../gui/frames/listening.py" />
            <source>holds no bytes of a device</source>
            <translation>не содержит байтов устройства</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>device file {path}</source>
            <translation>файл устройства {path}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>End what is being measured there, then press Save and connect again.</source>
            <translation>Завершите измерение, которое там идёт, затем нажмите «Сохранить и подключить» снова.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>The bytes cannot be had</source>
            <translation>Байты получить невозможно</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Looking for frames, checksum and numbers</source>
            <translation>Поиск кадров, контрольной суммы и чисел</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Looking for the checksum</source>
            <translation>Поиск контрольной суммы</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>taught from {heard}</source>
            <translation>обучено по {heard}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Not connected yet</source>
            <translation>Ещё не подключено</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>{name} is connected</source>
            <translation>{name} подключён</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>Its numbers are drawn in the tab Live; every tab knows it by its roles.</source>
            <translation>Его числа рисуются во вкладке «Вживую»; каждая вкладка знает его по ролям.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>A header has 1 to 8 bytes, and a frame more than it</source>
            <translation>В заголовке от 1 до 8 байтов, а в кадре — больше</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>The device file is not saved</source>
            <translation>Файл устройства не сохранён</translation>
        </message>
        <message>
            <location filename="../../gui/frames/presenter.py" />
            <source>"{sync}" is no row of bytes like "AA 55"</source>
            <translation>«{sync}» не является рядом байтов вида "AA 55"</translation>
        </message>
        <message>
            <location filename="../../gui/frames/saving.py" />
            <source>There is a device file "{stem}" of the program: choose another name</source>
            <translation>Есть файл устройства «{stem}» из программы: выберите другое имя</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Listening at every speed</source>
            <translation>Прослушивание на каждой скорости</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Reading {name}</source>
            <translation>Чтение {name}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>End what is being measured there, or choose another port.</source>
            <translation>Завершите измерение, которое там идёт, или выберите другой порт.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>No bytes from this port</source>
            <translation>Из этого порта нет байтов</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Choose a port first</source>
            <translation>Сначала выберите порт</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Listening at {baud} baud</source>
            <translation>Прослушивание на {baud} baud</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>The port is in use</source>
            <translation>Порт используется</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Bytes come, but at no speed do they repeat themselves: choose the BaudRate of the board's manual and Listen, then type Header and Length</source>
            <translation>Байты поступают, но ни на одной скорости не повторяются: выберите скорость из инструкции платы, нажмите «Слушать», затем введите заголовок и длину</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source.py" />
            <source>Silent at every speed; is the board switched on?</source>
            <translation>Тишина на каждой скорости; включена ли плата?</translation>
        </message>
        <message>
            <location filename="../../gui/frames/state.py" />
            <source>Nothing is described yet</source>
            <translation>Ещё ничего не описано</translation>
        </message>
        <message>
            <location filename="../../gui/frames/taught.py" />
            <source>Give the board a name</source>
            <translation>Дайте плате имя</translation>
        </message>
        <message>
            <location filename="../../gui/frames/taught.py" />
            <source>the description</source>
            <translation>описание</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>no checksum</source>
            <translation>без контрольной суммы</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{grouped} bytes</source>
            <translation>{grouped} [байт|байта|байтов]</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{text}, bytes {start} to {last}: {share} fit</source>
            <translation>{text}, байты с {start} по {last}: подходит {share}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>Byte {at} = {value}, {what}: frames of {length} bytes, {share} fit</source>
            <translation>Байт {at} = {value}, {what}: кадры по {length} байтов, подходит {share}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>none of the known checksums fits, so where a frame begins is a guess: the longest run of bytes that stay the same.</source>
            <translation>ни одна из известных контрольных сумм не подходит, поэтому начало кадра — догадка: самый длинный ряд неизменных байтов.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>no byte yet</source>
            <translation>ещё ни одного байта</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{text}, {grouped} a second</source>
            <translation>{text}, {grouped} в секунду</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>counts by {step}</source>
            <translation>считает по {step}</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>never changes</source>
            <translation>никогда не меняется</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>a noisy signal</source>
            <translation>шумный сигнал</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>rises or falls steadily</source>
            <translation>равномерно растёт или убывает</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>a few values, seldom changing</source>
            <translation>несколько значений, меняется редко</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>the whole length</source>
            <translation>полная длина</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>the payload, {add} bytes less</source>
            <translation>полезные данные, на {add} [байт|байта|байтов] меньше</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>, {hz} a second</source>
            <translation>, {hz} в секунду</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>Lines of {len} numbers{rate}; {share} of them read.</source>
            <translation>Строки по {len} чисел{rate}; прочитано {share}.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>{text} fits {share} of them.</source>
            <translation>{text} подходит для {share} из них.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>How many come in a second is not told: {why}.</source>
            <translation>Сколько их приходит в секунду, неизвестно: {why}.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/texts.py" />
            <source>Neither frames nor lines were found. Is the baud rate right? Noise at every speed means another parity, or a signal that is no serial one.</source>
            <translation>Не найдено ни кадров, ни строк. Верна ли скорость? Шум на каждой скорости означает другую чётность или сигнал, который не является последовательным.</translation>
        </message>
        <message>
            <location filename="../../gui/frames/view.py" />
            <source>Drag over columns to point at bytes, Enter makes numbers of them, Delete takes them away. A double click points at a whole part.</source>
            <translation>Протяните по столбцам, чтобы отметить байты; Enter делает из них числа, Delete убирает. Двойной щелчок отмечает всю часть.</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/page.py" />
            <source>Gyrocompass {device}</source>
            <translation>Гирокомпас {device}</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/working.py" />
            <source>{name}: the rows tell no heading of the base (column head_deg)</source>
            <translation>{name}: строки не содержат курса основания (столбец head_deg)</translation>
        </message>
        <message>
            <location filename="../../gui/gyrocompass/working.py" />
            <source>how long to average depends on the latitude: state it</source>
            <translation>длительность усреднения зависит от широты: укажите её</translation>
        </message>
        <message>
            <location filename="../../gui/hooks.py" />
            <source>A fault inside the program</source>
            <translation>Ошибка внутри программы</translation>
        </message>
        <message>
            <location filename="../../gui/hooks.py" />
            <source>{name}: {fault}. What was accepted is on the disk.</source>
            <translation>{name}: {fault}. Принятое уже на диске.</translation>
        </message>
        <message>
            <location filename="../../gui/hooks.py" />
            <source>Go on; if something behaves oddly, start the program anew and resume.</source>
            <translation>Продолжайте; если что-то работает странно, запустите программу снова и продолжите сеанс.</translation>
        </message>
        <message>
            <location filename="../../gui/jobs.py" />
            <source>calrig {name}</source>
            <translation>calrig {name}</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Plot</source>
            <translation>График</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Dial</source>
            <translation>Лимб</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Callout</source>
            <translation>Подсказка</translation>
        </message>
        <message>
            <location filename="../../gui/keys/own_keys.py" />
            <source>Banner</source>
            <translation>Сообщение</translation>
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
            <translation>Лист клавиш готов к печати</translation>
        </message>
        <message>
            <location filename="../../gui/keys/showing.py" />
            <source>The sheet of keys is not written</source>
            <translation>Лист клавиш не записан</translation>
        </message>
        <message>
            <location filename="../../gui/keys/showing.py" />
            <source>Make room there, or choose another folder of sessions in Preferences.</source>
            <translation>Освободите там место или выберите другую папку сеансов в «Настройках».</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>the record was not averaged</source>
            <translation>запись не усреднена</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>no samples came</source>
            <translation>отсчёты не пришли</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>nothing was recorded</source>
            <translation>ничего не записано</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>door opened</source>
            <translation>дверь открыта</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>the hour was not recorded</source>
            <translation>час не записан</translation>
        </message>
        <message>
            <location filename="../../gui/live/demo.py" />
            <source>{device} GyroOut</source>
            <translation>{device} GyroOut</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>export failed</source>
            <translation>экспорт не удался</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>Charts, SVG</source>
            <translation>Графики, SVG</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>Charts, PNG</source>
            <translation>Графики, PNG</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>Charts, PDF</source>
            <translation>Графики, PDF</translation>
        </message>
        <message>
            <location filename="../../gui/live/exporting.py" />
            <source>{name} and {table} written</source>
            <translation>{name} и {table} записаны</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Max − Min</source>
            <translation>Макс. − мин.</translation>
        </message>
        <message>
            <location filename="../../gui/live/figures.py" />
            <source>Slope, 1/s</source>
            <translation>Наклон, 1/s</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>interrupted record</source>
            <translation>прерванная запись</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>interrupted records</source>
            <translation>прерванные записи</translation>
        </message>
        <message>
            <location filename="../../gui/live/interrupted.py" />
            <source>So were {n} others.</source>
            <translation>Так же ещё {n}.</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>The record stays where it was</source>
            <translation>Запись остаётся там, где была</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>Samples are not recorded</source>
            <translation>Отсчёты не записываются</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>CVGCom's file ends here</source>
            <translation>Файл CVGCom здесь кончается</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>The end of the record is not stored</source>
            <translation>Конец записи не сохранён</translation>
        </message>
        <message>
            <location filename="../../gui/live/keeper.py" />
            <source>cannot take the record: {strerror}</source>
            <translation>невозможно принять запись: {strerror}</translation>
        </message>
        <message>
            <location filename="../../gui/live/loading.py" />
            <source>{name} has been opened with doubts</source>
            <translation>{name} открыто с оговорками</translation>
        </message>
        <message>
            <location filename="../../gui/live/loading.py" />
            <source>The record cannot be opened</source>
            <translation>Запись невозможно открыть</translation>
        </message>
        <message>
            <location filename="../../gui/live/means.py" />
            <source>exists already; nothing measured is overwritten</source>
            <translation>уже существует; ничего измеренного не перезаписывается</translation>
        </message>
        <message>
            <location filename="../../gui/live/presenter.py" />
            <source>{port}, {name}, {rate_hz} Hz</source>
            <translation>{port}, {name}, {rate_hz} Hz</translation>
        </message>
        <message>
            <location filename="../../gui/live/presenter.py" />
            <source>The record cannot begin</source>
            <translation>Запись невозможно начать</translation>
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
            <translation>MATLAB 5 вмещает не более 2 GB: выберите более короткий участок или CSV</translation>
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
            <translation>{folder}: на диске осталось {megabytes}, хватит на {lasting} при {per_s} kB/s; сначала освободите место</translation>
        </message>
        <message>
            <location filename="../../gui/live/space.py" />
            <source>{there}: cannot be looked at: {strerror}</source>
            <translation>{there}: невозможно просмотреть: {strerror}</translation>
        </message>
        <message>
            <location filename="../../gui/live/tab.py" />
            <source>A record is running.</source>
            <translation>Идёт запись.</translation>
        </message>
        <message>
            <location filename="../../gui/live/trace.py" />
            <source>link lost</source>
            <translation>связь потеряна</translation>
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
            <translation>команды {arguments} нет; есть: {join}</translation>
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
            <translation>открыть окно на симулированном стенде: pointer, clbacc или полный адрес sim://</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>folder of all sessions (~/CalRig)</source>
            <translation>папка всех сеансов (~/CalRig)</translation>
        </message>
        <message>
            <location filename="../../gui/main.py" />
            <source>calrig {version}</source>
            <translation>calrig {version}</translation>
        </message>
        <message>
            <location filename="../../gui/measured_file.py" />
            <source>holds nothing that a certificate can be made of</source>
            <translation>не содержит ничего, из чего можно составить сертификат</translation>
        </message>
        <message>
            <location filename="../../gui/measured_file.py" />
            <source>holds the test {test}; certificates are made of {join}, record</source>
            <translation>содержит испытание {test}; сертификаты составляют из {join}, record</translation>
        </message>
        <message>
            <location filename="../../gui/measured_file.py" />
            <source>holds several devices: {names}; choose one of them</source>
            <translation>содержит несколько устройств: {names}; выберите одно</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>Effects that were added to the model</source>
            <translation>Эффекты, добавленные в модель</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>Effect</source>
            <translation>Эффект</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>Where</source>
            <translation>Где</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>taken out in use</source>
            <translation>исключается при работе</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/added_table.py" />
            <source>this test alone</source>
            <translation>только это испытание</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>No device</source>
            <translation>Нет устройства</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>Open Properties at the top, choose the port, press Scan and OK.</source>
            <translation>Откройте «Свойства» вверху, выберите порт, нажмите «Поиск» и OK.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>Waiting for samples</source>
            <translation>Ожидание отсчётов</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>The port is open. The first frame has not come yet.</source>
            <translation>Порт открыт. Первый кадр ещё не пришёл.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/bench.py" />
            <source>The sample rate is being measured.</source>
            <translation>Измеряется частота отсчётов.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>accept as</source>
            <translation>принять как</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Take it anyway</source>
            <translation>Взять всё равно</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{capitalize} {number}, {done_before} of {total}.</source>
            <translation>{capitalize} {number}, {done_before} из {total}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{capitalize} {number} done</source>
            <translation>{capitalize} {number} готово</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>On the disk. Next: {noun} {number}, {place}, {setting}.</source>
            <translation>На диске. Далее: {noun} {number}, {place}, {setting}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Nothing is being measured.</source>
            <translation>Ничего не измеряется.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{order}, {place}; or measure what is there.</source>
            <translation>{order}, {place}; или измерьте то, что стоит.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>All {nouns} at {here} are done</source>
            <translation>Все {nouns} при {here} измерены</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Set the chamber to {after}, wait until the unit has its temperature, then go on.</source>
            <translation>Установите камеру на {after}, подождите, пока изделие примет температуру, затем продолжайте.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Link lost</source>
            <translation>Связь потеряна</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Everything accepted so far is on the disk. Measuring goes on when the device is back.</source>
            <translation>Всё принятое до сих пор уже на диске. Измерение продолжится, когда устройство вернётся.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Not taken</source>
            <translation>Не принято</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{done_before} {nouns} are on the disk.</source>
            <translation>{nouns} на диске: {done_before}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>It settles; then press Space to accumulate {time}.</source>
            <translation>Успокаивается; затем нажмите Space, чтобы накапливать {time}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>{asked}Then press Space to accumulate {time}.</source>
            <translation>{asked}Затем нажмите Space, чтобы накапливать {time}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Settling</source>
            <translation>Жду покоя</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Nothing was recorded; see below.</source>
            <translation>Ничего не записано; см. ниже.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Press Process Data (F5).</source>
            <translation>Нажмите «Обработать данные» (F5).</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Too short</source>
            <translation>Слишком коротко</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Accept as {noun} {number}</source>
            <translation>Принять как {noun} {number}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Measure {noun} {number}</source>
            <translation>Измерить {noun} {number}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/cues.py" />
            <source>Nothing has been recorded under {label}.</source>
            <translation>Под {label} ничего не записано.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>the plan was not finished</source>
            <translation>план не завершён</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>nothing was processed</source>
            <translation>ничего не обработано</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>no position was accepted</source>
            <translation>ни одно положение не принято</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/demonstrating.py" />
            <source>no accumulation began</source>
            <translation>накопление не началось</translation>
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
            <translation>ни один сеанс не открыт</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>give the mounts</source>
            <translation>укажите установки</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>{name} holds {len} devices</source>
            <translation>{name} содержит {len} [устройство|устройства|устройств]</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>Which one shall be processed?</source>
            <translation>Какое обработать?</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>mounts {mounts}</source>
            <translation>установки {mounts}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>It stood {replace}</source>
            <translation>Он стоял {replace}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/loading.py" />
            <source>device {name}</source>
            <translation>устройство {name}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/presenter.py" />
            <source>Free angles</source>
            <translation>Свободные углы</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/printed.py" />
            <source>info, warning or error</source>
            <translation>info, warning или error</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/printed.py" />
            <source>pairs of value and uncertainty</source>
            <translation>пары значения и неопределённости</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results.py" />
            <source>{key} results</source>
            <translation>{key} results</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/results.py" />
            <source>The data cannot be processed</source>
            <translation>Данные невозможно обработать</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>Continue it</source>
            <translation>Продолжить его</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>{key} unfinished</source>
            <translation>{key} unfinished</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>{others} older ones wait in the folder of sessions.</source>
            <translation>В папке сеансов ждут более старые: {others}.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>A session of {device} is not finished</source>
            <translation>Сеанс {device} не завершён</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>Begun {started}, {done} of {total} {nouns} are on the disk.{more}</source>
            <translation>Начат {started}, на диске {done} из {total}, {nouns}.{more}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/resuming.py" />
            <source>a session that cannot be read is not offered</source>
            <translation>сеанс, который невозможно прочитать, не предлагается</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>It belongs to the session; press New session to change it</source>
            <translation>Принадлежит сеансу; чтобы изменить, нажмите «Новый сеанс»</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>An accumulation is running</source>
            <translation>Идёт накопление</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>All is done; pick a line of the list to measure it once more</source>
            <translation>Всё измерено; выберите строку списка, чтобы измерить её ещё раз</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/scene.py" />
            <source>The link is lost</source>
            <translation>Связь потеряна</translation>
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
            <translation>Не сохранено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>{name} cannot go on with the session of {device}</source>
            <translation>{name} не может продолжить сеанс {device}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>It sends other channels.</source>
            <translation>Он передаёт другие каналы.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>Connect the unit that the session was begun with, or press New session.</source>
            <translation>Подключите изделие, с которым начат сеанс, или нажмите «Новый сеанс».</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>No session can be made</source>
            <translation>Сеанс невозможно создать</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/sitting.py" />
            <source>The text file is behind</source>
            <translation>Текстовый файл отстал</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>{key} export</source>
            <translation>{key} export</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>An accumulation is running.</source>
            <translation>Идёт накопление.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>{key} session</source>
            <translation>{key} session</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/tab.py" />
            <source>The session cannot be opened</source>
            <translation>Сеанс невозможно открыть</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>Store again</source>
            <translation>Сохранить снова</translation>
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
            <translation>{label} отброшено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>It is held in memory until it is stored or measured again.</source>
            <translation>Оно хранится в памяти, пока не будет записано или измерено снова.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>Make room on the disk, then store it again.</source>
            <translation>Освободите место на диске, затем сохраните снова.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{label} taken back</source>
            <translation>{label} отменено</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>accumulated for {label}, recorded as {label2}</source>
            <translation>накоплено для {label}, записано как {label2}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>{label} is measured, but not on the disk</source>
            <translation>{label} измерено, но не на диске</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/taking.py" />
            <source>taken by the operator</source>
            <translation>принято оператором</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Accumulates by itself once the unit is at rest.</source>
            <translation>Накапливает сам, когда изделие в покое.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>The unit is moving.</source>
            <translation>Изделие движется.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>At rest; hands off.</source>
            <translation>В покое; не трогайте.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Do not touch the head.</source>
            <translation>Не трогайте головку.</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>The head moved</source>
            <translation>Головка двигалась</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Wrong position</source>
            <translation>Неверное положение</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Positions</source>
            <translation>Положения</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>All {nouns} done</source>
            <translation>Измерены все {nouns}</translation>
        </message>
        <message>
            <location filename="../../gui/measuring/words.py" />
            <source>Bolt the unit on anew with {place}.</source>
            <translation>Закрепите изделие снова, {place}.</translation>
        </message>
        <message>
            <location filename="../../gui/messages.py" />
            <source>Nothing was changed. Choose another file, or correct the place that is named.</source>
            <translation>Ничего не изменено. Выберите другой файл или исправьте названное место.</translation>
        </message>
        <message>
            <location filename="../../gui/messages.py" />
            <source>Make room there, or choose another folder; then try again.</source>
            <translation>Освободите там место или выберите другую папку; затем попробуйте снова.</translation>
        </message>
        <message>
            <location filename="../../gui/methods/comparison_demo.py" />
            <source>the files were not read</source>
            <translation>файлы не прочитаны</translation>
        </message>
        <message>
            <location filename="../../gui/methods/comparison_demo.py" />
            <source>there is no noise to compare</source>
            <translation>нет шума для сравнения</translation>
        </message>
        <message>
            <location filename="../../gui/methods/comparison_demo.py" />
            <source>play Allan first</source>
            <translation>сначала проиграйте часть Allan</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>the tumble was not evaluated</source>
            <translation>оборот не оценён</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>no advice was given</source>
            <translation>совет не дан</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>nothing was proposed</source>
            <translation>ничего не предложено</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>it was not chosen</source>
            <translation>он не выбран</translation>
        </message>
        <message>
            <location filename="../../gui/methods/demo.py" />
            <source>the plan was not predicted</source>
            <translation>план не предсказан</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/demo.py" />
            <source>legacy rotation_table</source>
            <translation>legacy rotation_table</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/formats.py" />
            <source>Run file of the rates</source>
            <translation>Файл серии со скоростями</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/free.py" />
            <source>Z down</source>
            <translation>Z вниз</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/free.py" />
            <source>Rotation Around {axis}, own list{name}</source>
            <translation>Вращение вокруг {axis}, собственный список{name}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/guide.py" />
            <source>the table changed its rate during the accumulation ({which}): it stopped, slowed down or was still gaining speed; wait until it turns steadily and accumulate again</source>
            <translation>стол изменил скорость во время накопления ({which}): он остановился, замедлился или ещё набирал скорость; подождите, пока вращение станет равномерным, и накопите снова</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/guide.py" />
            <source>No gyros</source>
            <translation>Нет гироскопов</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/guide.py" />
            <source>{name} stood at {mean} throughout: the gyro or its converter is at the end of its range, or the channel is stuck; leave the rate out, or measure a smaller one</source>
            <translation>{name} всё время показывал {mean}: гироскоп или его преобразователь на пределе диапазона, или канал завис; пропустите эту скорость или измерьте меньшую</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>table and head run are not fitted together while effects are added: they were found in one of them alone</source>
            <translation>измерения на столе и на головке не оцениваются вместе, пока добавлены эффекты: они найдены только в одном из них</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>{names}: the scale factors are negative, which is legal; the outputs fall when the unit turns counter-clockwise seen from above</source>
            <translation>{names}: масштабные коэффициенты отрицательны, что допустимо; выходы убывают, когда изделие вращается против часовой стрелки, если смотреть сверху</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>{name} holds a {sensor} in the test {test}; here are gyros on the rate table, or at rest on the dividing head</source>
            <translation>{name} содержит {sensor} в испытании {test}; здесь гироскопы на поворотном столе или в покое на делительной головке</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/processing.py" />
            <source>there is nothing to process</source>
            <translation>обрабатывать нечего</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>same unit</source>
            <translation>то же изделие</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>They are one unit</source>
            <translation>Это одно изделие</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>Leave the other one out</source>
            <translation>Не брать второй</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>{key} two files</source>
            <translation>{key} two files</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>Table and head run are of two units</source>
            <translation>Серии стола и головки — от двух изделий</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/results.py" />
            <source>{refused} Each was processed by itself.</source>
            <translation>{refused} Каждая обработана отдельно.</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>holds, p = {worst}</source>
            <translation>принята, p = {worst}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Rate table: scale factor and zero (Table 3.6), U at 95 %</source>
            <translation>Поворотный стол: масштабный коэффициент и нулевой сигнал (таблица 3.6), U при 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>not tested</source>
            <translation>не проверено</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>rejected, p = {worst}</source>
            <translation>отвергнута, p = {worst}</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Nonlinearity of {full_scale} deg/s</source>
            <translation>Нелинейность от {full_scale} deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Straightness, asymmetry, hysteresis, cross axes, U at 95 %</source>
            <translation>Прямолинейность, асимметрия, гистерезис, перекрёстные оси, U при 95 %</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Parameters</source>
            <translation>Параметры</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Error of the calibrated rate</source>
            <translation>Погрешность калиброванной скорости</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Set rate, deg/s</source>
            <translation>Заданная скорость, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Error, deg/s</source>
            <translation>Погрешность, deg/s</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Measured outputs, {unit}, and errors, deg/s (Table 3.4)</source>
            <translation>Измеренные выходы, {unit}, и погрешности, deg/s (таблица 3.4)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>g-sensitivity on the head (Table 3.6)</source>
            <translation>g-чувствительность на головке (таблица 3.6)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Measured outputs and residuals, {unit} (Table 3.5)</source>
            <translation>Измеренные выходы и остатки, {unit} (таблица 3.5)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Rate table and head together (3.3)</source>
            <translation>Поворотный стол и головка вместе (3.3)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Calibrated rates, deg/s (Table 3.7)</source>
            <translation>Калиброванные скорости, deg/s (таблица 3.7)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Errors of Table 3.7</source>
            <translation>Погрешности таблицы 3.7</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Straight line</source>
            <translation>Прямая</translation>
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
            <translation>ω заданная</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>ω calibrated</source>
            <translation>ω калиброванная</translation>
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
            <translation>Нуль без силы тяжести</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>k of positive rates</source>
            <translation>k положительных скоростей</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>k of negative rates</source>
            <translation>k отрицательных скоростей</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Asymmetry (IEEE 528)</source>
            <translation>Асимметрия (IEEE 528)</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Bias asymmetry</source>
            <translation>Асимметрия нулевого сигнала</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Hysteresis, up less down</source>
            <translation>Гистерезис, вверх минус вниз</translation>
        </message>
        <message>
            <location filename="../../gui/rate_table/tables.py" />
            <source>Threshold, between</source>
            <translation>Порог, между</translation>
        </message>
        <message>
            <location filename="../../gui/record_noise.py" />
            <source>{name}: the record is in {unit}, no unit of a {kind}; state the scale factor, or type N, B and K as the Allan tab tells them</source>
            <translation>{name}: запись в {unit}, что не является единицей {kind}; укажите масштабный коэффициент или введите N, B и K, как их показывает вкладка Аллана</translation>
        </message>
        <message>
            <location filename="../../gui/rig/view.py" />
            <source>{replace} ODH, {words}</source>
            <translation>{replace} ODH, {words}</translation>
        </message>
        <message>
            <location filename="../../gui/services.py" />
            <source>no certificate can be made of files here</source>
            <translation>из файлов здесь сертификата не составить</translation>
        </message>
        <message>
            <location filename="../../gui/settings.py" />
            <source>{path}: the preferences cannot be read ({error}); defaults are used</source>
            <translation>{path}: настройки невозможно прочитать ({error}); взяты типовые</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/demo.py" />
            <source>the cycle was not processed</source>
            <translation>цикл не обработан</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/exporting.py" />
            <source>outputs of a standing unit over temperature</source>
            <translation>выходы неподвижного изделия по температуре</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/exporting.py" />
            <source>nothing was found over temperature; see the notes</source>
            <translation>по температуре ничего не найдено; см. замечания</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/tab.py" />
            <source>Over temperature</source>
            <translation>По температуре</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/working.py" />
            <source>a record of a standing unit is taken by itself: remove the others from the list</source>
            <translation>запись неподвижного изделия берётся сама по себе: уберите остальные из списка</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>New to CalRig?</source>
            <translation>Впервые в CalRig?</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>A tour on the simulated rig shows the window in two minutes; it also waits in Menu, Help.</source>
            <translation>Обзор на симулированном стенде за две минуты показывает окно; он есть также в «Меню», «Справка».</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>Start the tour</source>
            <translation>Начать обзор</translation>
        </message>
        <message>
            <location filename="../../gui/tour/tour.py" />
            <source>Not now</source>
            <translation>Не сейчас</translation>
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
            <translation>у исследования без разложения нет его таблицы</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/findings.py" />
            <source>a study without a flip has no table of it</source>
            <translation>у исследования без переворота нет его таблицы</translation>
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
            <translation>Оборот {device}</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/presenter.py" />
            <source>holds no session of the dividing head yet; measure one in that tab, or load a file</source>
            <translation>ещё не содержит сеанса делительной головки; измерьте его в той вкладке или загрузите файл</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/chart_export.py" />
            <source>Title</source>
            <translation>Заголовок</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/chart_export.py" />
            <source>{path}: no such picture format; use {join}</source>
            <translation>{path}: нет такого формата рисунка; берите {join}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/history.py" />
            <source>a history needs a positive rate, not {rate}</source>
            <translation>истории нужна положительная частота, а не {rate}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/history.py" />
            <source>sample numbers from {index} do not follow {next}</source>
            <translation>номера отсчётов с {index} не следуют за {next}</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/number_text.py" />
            <source>an uncertainty of {uncertainty} gives no number of digits</source>
            <translation>неопределённость {uncertainty} не даёт числа цифр</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/screenshots.py" />
            <source>{path}: the picture could not be written</source>
            <translation>{path}: рисунок невозможно записать</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/states.py" />
            <source>to come</source>
            <translation>предстоит</translation>
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
            <translation>Язык</translation>
        </message>
        <message>
            <location filename="../../core/allan/conventions.py" />
            <source>angle quantisation</source>
            <translation>квантование угла</translation>
        </message>
        <message>
            <location filename="../../core/allan/conventions.py" />
            <source>velocity quantisation</source>
            <translation>квантование скорости</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>a regression needs one stretch without gaps: choose 'longest'</source>
            <translation>регрессии нужен один участок без пропусков: выберите «longest»</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>the channel did not move during the record; leave it out</source>
            <translation>канал не менялся за время записи; не берите его</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>these move together; leave one out or lower the order</source>
            <translation>эти каналы меняются вместе; уберите один или уменьшите порядок</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>{name}: {value} +- {spread} {unit} (k = 1) is not told from zero; the regression on it removes noise only</source>
            <translation>{name}: {value} +- {spread} {unit} (k = 1) не отличается от нуля; регрессия по нему убирает только шум</translation>
        </message>
        <message>
            <location filename="../../core/allan/detrend.py" />
            <source>channel {name} has values that are not finite; choose another</source>
            <translation>канал {name} содержит не конечные значения; выберите другой</translation>
        </message>
        <message>
            <location filename="../../core/allan/deviation.py" />
            <source>the sampling rate must be positive, not {rate}</source>
            <translation>частота дискретизации должна быть положительной, а не {rate}</translation>
        </message>
        <message>
            <location filename="../../core/allan/deviation.py" />
            <source>the Allan deviation at tau = {rate} s is zero: the samples repeat exactly (a synthetic or stuck record)</source>
            <translation>девиация Аллана при tau = {rate} s равна нулю: отсчёты точно повторяются (искусственная или зависшая запись)</translation>
        </message>
        <message>
            <location filename="../../core/allan/faults.py" />
            <source>{longest} samples in succession are equal, where at most {expected} could be expected: the channel was stuck for a time</source>
            <translation>{longest} [отсчёт|отсчёта|отсчётов] подряд одинаковы, тогда как ожидать можно не более {expected}: канал на какое-то время завис</translation>
        </message>
        <message>
            <location filename="../../core/allan/faults.py" />
            <source>{piled} samples lie exactly at the extreme value {extreme}, but only {beside} at the value beside it: the signal is clipped, noise is understated</source>
            <translation>{piled} [отсчёт|отсчёта|отсчётов] лежат точно на крайнем значении {extreme}, а рядом с ним только {beside}: сигнал ограничен, шум занижен</translation>
        </message>
        <message>
            <location filename="../../core/allan/leastsquares.py" />
            <source>{len} points of the Allan curve lie between {shortest} s and a third of the record; {len2} terms need more: record longer</source>
            <translation>{len} [точка|точки|точек] кривой Аллана лежат между {shortest} s и третью записи; для {len2} составляющих нужно больше: записывайте дольше</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the noise is not flat up to {top} Hz (a filter in the sensor, a resonance, vibration); frequencies up to {band} Hz and tau from {band2} s were fitted</source>
            <translation>шум не ровный до {top} Hz (фильтр в датчике, резонанс, вибрация); оценено по частотам до {band} Hz и tau от {band2} s</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the record drifts steadily by {value} +- {ramp} {unit_of} (k = 1); it was taken off before the noise was fitted. Was the sensor warmed up?</source>
            <translation>запись равномерно дрейфует на {value} +- {ramp} {unit_of} (k = 1); дрейф исключён перед оценкой шума. Был ли датчик прогрет?</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>a noise fit needs one stretch without gaps: choose 'longest'</source>
            <translation>для оценки шума нужен один участок без пропусков: выберите «longest»</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>{found} samples without a gap: the noise terms cannot be told apart in fewer than {shortest}; record longer</source>
            <translation>{found} [отсчёт|отсчёта|отсчётов] без пропусков: составляющие шума не различить менее чем за {shortest}; записывайте дольше</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the spectrum is {ratio} times the fitted noise about {frequency} Hz (period {frequency2} s): vibration, a thermostat or a warm-up rather than noise</source>
            <translation>спектр в {ratio} [раз|раза|раз] превышает оценённый шум около {frequency} Hz (период {frequency2} s): скорее вибрация, термостат или прогрев, чем шум</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>the spectrum has another shape than white, flicker and random walk noise together; the intervals are too narrow</source>
            <translation>спектр имеет иную форму, чем белый шум, фликкер-шум и случайное блуждание вместе; интервалы слишком узки</translation>
        </message>
        <message>
            <location filename="../../core/allan/noise.py" />
            <source>{symbol} is {value} {unit} by likelihood but {value2} by least squares of the Allan variance, {abs} standard uncertainties apart: trust neither before the spectrum was looked at</source>
            <translation>{symbol} равен {value} {unit} по правдоподобию, но {value2} по наименьшим квадратам дисперсии Аллана, разница {abs} стандартных неопределённостей: не доверяйте ни одному, пока не просмотрен спектр</translation>
        </message>
        <message>
            <location filename="../../core/allan/other.py" />
            <source>these deviations need one stretch without gaps: choose 'longest'</source>
            <translation>этим девиациям нужен один участок без пропусков: выберите «longest»</translation>
        </message>
        <message>
            <location filename="../../core/allan/other.py" />
            <source>the {kind} deviation is offered up to {most} samples, the record has {x}: average neighbouring samples first</source>
            <translation>девиация {kind} доступна до {most} [отсчёта|отсчётов|отсчётов], в записи их {x}: сначала усредните соседние отсчёты</translation>
        </message>
        <message>
            <location filename="../../core/allan/other.py" />
            <source>Hadamard, modified and total deviations need the optional package AllanTools: pip install "calrig[allan]"</source>
            <translation>Девиациям Адамара, модифицированной и полной нужен дополнительный пакет AllanTools: pip install "calrig[allan]"</translation>
        </message>
        <message>
            <location filename="../../core/allan/preview.py" />
            <source>the preview needs a model with a random walk N above zero</source>
            <translation>для предварительного просмотра нужна модель со случайным блужданием N больше нуля</translation>
        </message>
        <message>
            <location filename="../../core/allan/preview.py" />
            <source>a record of {duration} s holds no spectrum up to {top} Hz</source>
            <translation>запись длительностью {duration} s не содержит спектра до {top} Hz</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>{lost} samples were lost; only the longest gap-free stretch is analysed: {int} of {x} samples</source>
            <translation>потеряно отсчётов: {lost}; анализируется только самый длинный участок без пропусков: {int} из {x} [отсчёта|отсчётов|отсчётов]</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>{lost} samples were lost; the differences within {len} gap-free stretches are pooled, the longest has {int} samples</source>
            <translation>потеряно отсчётов: {lost}; объединены разности внутри {len} [участка|участков|участков] без пропусков, в самом длинном {int} [отсчёт|отсчёта|отсчётов]</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>the record has {len} time stamps; record longer</source>
            <translation>в записи {len} [отметка|отметки|отметок] времени; записывайте дольше</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>time does not increase at sample {at} ({time} s, then {time2} s; {len} such places): the file is damaged or two runs were joined</source>
            <translation>время не растёт на отсчёте {at} ({time} s, затем {time2} s; таких мест {len}): файл повреждён или соединены две серии</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>samples are not uniform in time: {jumps} % of the steps are longer than the usual {middle} s. Are these arrival times of bursts? Use the device's counter</source>
            <translation>отсчёты неравномерны во времени: {jumps} % шагов длиннее обычных {middle} s. Это время прихода пакетов? Воспользуйтесь счётчиком устройства</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>samples are not uniform in time: sample {worst} at {time} s is {off} of the interval {interval} s off the grid; use the device's counter as the time axis, or resample</source>
            <translation>отсчёты неравномерны во времени: отсчёт {worst} на {time} s смещён на {off} интервала {interval} s от сетки; возьмите счётчик устройства как ось времени или пересчитайте отсчёты</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>a record is one-dimensional, not {shape}</source>
            <translation>запись должна быть одномерной, а не {shape}</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>the record has {counted} usable samples: an Allan curve needs at least {shortest_record}; record longer</source>
            <translation>в записи {counted} пригодных отсчётов: кривой Аллана нужно не менее {shortest_record}; записывайте дольше</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>all {count} samples equal {lowest}: the channel is stuck or not connected</source>
            <translation>все {count} [отсчёт|отсчёта|отсчётов] равны {lowest}: канал завис или не подключён</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>the record has gaps: {lost} samples lost, the first after sample {first} of {x}; analyse the longest gap-free stretch, or pool the stretches</source>
            <translation>в записи есть пропуски: потеряно отсчётов {lost}, первый после отсчёта {first} из {x}; анализируйте самый длинный участок без пропусков или объедините участки</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>{len} sample numbers for {x} samples</source>
            <translation>{len} [номер|номера|номеров] отсчётов на {x} [отсчёт|отсчёта|отсчётов]</translation>
        </message>
        <message>
            <location filename="../../core/allan/record.py" />
            <source>sample numbers do not increase at sample {at}: two runs were joined</source>
            <translation>номера отсчётов не растут на отсчёте {at}: соединены две серии</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>{count} samples so far: an Allan curve needs {shortest_record}</source>
            <translation>пока {count} [отсчёт|отсчёта|отсчётов]: кривой Аллана нужно {shortest_record}</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>no stretch without lost samples is long enough; check the link</source>
            <translation>ни один участок без потерянных отсчётов недостаточно длинен; проверьте связь</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>all {count} samples so far are equal: the channel is stuck or not connected</source>
            <translation>все {count} [отсчёт|отсчёта|отсчётов] до сих пор одинаковы: канал завис или не подключён</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>factor {step} is not a multiple of its stride {stride}</source>
            <translation>множитель {step} не кратен своему шагу {stride}</translation>
        </message>
        <message>
            <location filename="../../core/allan/streaming.py" />
            <source>{cuts} gaps so far; no difference is taken across them</source>
            <translation>пропусков до сих пор: {cuts}; разности через них не берутся</translation>
        </message>
        <message>
            <location filename="../../core/allan/taus.py" />
            <source>the record has {x} samples: an Allan curve needs at least {shortest_record}; record longer</source>
            <translation>в записи {x} [отсчёт|отсчёта|отсчётов]: кривой Аллана нужно не менее {shortest_record}; записывайте дольше</translation>
        </message>
        <message>
            <location filename="../../core/allan/whittle.py" />
            <source>the likelihood has no upper limit: the record does not determine the term</source>
            <translation>правдоподобие не имеет верхней границы: запись не определяет эту составляющую</translation>
        </message>
        <message>
            <location filename="../../core/allan/whittle.py" />
            <source>the spectrum of the record is zero within the band; is the record stuck?</source>
            <translation>спектр записи равен нулю в пределах полосы; не зависла ли запись?</translation>
        </message>
        <message>
            <location filename="../../core/allan/whittle.py" />
            <source>no noise model fits the spectrum up to {limit} Hz: the record is too short, or it holds something that is not noise (motion, mains, a step)</source>
            <translation>ни одна модель шума не подходит к спектру до {limit} Hz: запись слишком коротка или содержит то, что не является шумом (движение, сеть питания, скачок)</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>they are of different devices, {serial} and {serial2}</source>
            <translation>они от разных устройств, {serial} и {serial2}</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>in different units, not compared: {join}</source>
            <translation>в разных единицах, не сравниваются: {join}</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>{alone} parameters stand in one of them only</source>
            <translation>{alone} [параметр|параметра|параметров] есть только в одном из них</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>they were measured {apart} K apart ({temperature_c} and {temperature_c2} °C): a part of the differences is temperature</source>
            <translation>они измерены с разницей {apart} K ({temperature_c} и {temperature_c2} °C): часть разностей вызвана температурой</translation>
        </message>
        <message>
            <location filename="../../core/archive/compare.py" />
            <source>they have no parameter in common</source>
            <translation>общих параметров у них нет</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>the files of the sessions are untouched</source>
            <translation>файлы сеансов не тронуты</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the database of the archive refuses ({said}); {safe}</source>
            <translation>{name}: база данных архива отказывает ({said}); {safe}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: another program has been writing to it for {wait_s} s; try again</source>
            <translation>{name}: другая программа пишет в неё уже {wait_s} s; попробуйте ещё раз</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the index is damaged ({said}); {safe}: open the archive again</source>
            <translation>{name}: индекс повреждён ({said}); {safe}: откройте архив снова</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: cannot be written ({said}); {safe}</source>
            <translation>{name}: невозможно записать ({said}); {safe}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the disk is full; {safe}: free some space, then refresh</source>
            <translation>{name}: диск заполнен; {safe}: освободите место, затем обновите</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>disk I/O</source>
            <translation>disk I/O</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: the disk is full or does not answer ({said}); {safe}: free some space or connect it again, then refresh</source>
            <translation>{name}: диск заполнен или не отвечает ({said}); {safe}: освободите место или подключите его снова, затем обновите</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{get_backend_name}: the archive knows postgresql and sqlite</source>
            <translation>{get_backend_name}: архив знает postgresql и sqlite</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>disk is full</source>
            <translation>диск заполнен</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>No space</source>
            <translation>Нет места</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>BEGIN IMMEDIATE</source>
            <translation>BEGIN IMMEDIATE</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>the index was damaged; it is kept as {name} and a new one is made from the files, which are untouched</source>
            <translation>индекс был повреждён; он сохранён как {name}, а новый создан из файлов, которые не тронуты</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{root} may not be written to: its index is kept until the program ends</source>
            <translation>в {root} нельзя записывать: индекс хранится до завершения программы</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: this archive was made by a newer CalRig (schema {found}; this program knows {version}): it is shown and not changed; update CalRig</source>
            <translation>{name}: этот архив создан более новой версией CalRig (схема {found}; эта программа знает {version}): он показан без изменений; обновите CalRig</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>the address of the database is none; expected postgresql://USER@HOST/DATABASE, or nothing for a file beside the sessions</source>
            <translation>адрес базы данных неверен; ожидается postgresql://USER@HOST/DATABASE или ничего для файла рядом с сеансами</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{name}: needs the PostgreSQL driver: pip install "calrig[postgres]"</source>
            <translation>{name}: нужен драйвер PostgreSQL: pip install "calrig[postgres]"</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>malformed text: {error}</source>
            <translation>повреждённый текст: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>not a database</source>
            <translation>не база данных</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>file is encrypted</source>
            <translation>файл зашифрован</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>PRAGMA quick_check(1)</source>
            <translation>PRAGMA quick_check(1)</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>malformed: {said}</source>
            <translation>повреждено: {said}</translation>
        </message>
        <message>
            <location filename="../../core/archive/database.py" />
            <source>{one}: damaged, and cannot be set aside ({strerror}): close other programs that use it and try again</source>
            <translation>{one}: повреждён, и его не удаётся отложить ({strerror}): закройте другие программы, которые им пользуются, и попробуйте снова</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>{other_units} earlier values are in another unit than {unit} and are left out</source>
            <translation>{other_units} прежних значений в других единицах, чем {unit}; они пропущены</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>{bad} calibrations with errors are shown and do not count</source>
            <translation>{bad} [калибровка|калибровки|калибровок] с ошибками показаны, но не учтены</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>{far} calibrations not at about {temperature_c} °C are shown and do not count</source>
            <translation>{far} [калибровка|калибровки|калибровок] не около {temperature_c} °C показаны, но не учтены</translation>
        </message>
        <message>
            <location filename="../../core/archive/history.py" />
            <source>a history of nothing</source>
            <translation>не из чего составить историю</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>already there</source>
            <translation>уже есть</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>not known</source>
            <translation>неизвестен</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{kind} of {join}</source>
            <translation>{kind} из {join}</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: a thousand files of the name {name}</source>
            <translation>{folder}: тысяча файлов с именем {name}</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: there is no such folder</source>
            <translation>{folder}: такой папки нет</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: lies in the archive itself; what is in it is found there</source>
            <translation>{folder}: лежит в самом архиве; то, что в ней, находят там</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>{folder}: holds the archive itself: name the folders beside it</source>
            <translation>{folder}: содержит сам архив: укажите папки рядом с ним</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>no kind of file that is archived</source>
            <translation>не тот вид файла, что архивируется</translation>
        </message>
        <message>
            <location filename="../../core/archive/importing.py" />
            <source>what was imported before stays</source>
            <translation>то, что импортировано раньше, остаётся</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>pass: the value and its expanded uncertainty (95 %) lie within the limits; fail: both lie beyond one; otherwise undecided (JCGM 106, guard band w = U)</source>
            <translation>соответствует: значение и его расширенная неопределённость (95 %) лежат в пределах; не соответствует: оба за пределом; иначе не решено (JCGM 106, защитная полоса w = U)</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>limit {number}</source>
            <translation>предел {number}</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>holds something else than [[limit]] tables</source>
            <translation>содержит нечто иное, чем таблицы [[limit]]</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where} is no table: write [[limit]]</source>
            <translation>{where} не является таблицей: пишите [[limit]]</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where}: {join} is not known</source>
            <translation>{where}: {join} неизвестно</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where}: {join} are texts</source>
            <translation>{where}: {join} — это тексты</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where} names no parameter</source>
            <translation>{where} не называет параметра</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where} needs a number as low, as high, or as both</source>
            <translation>{where}: нужно число как low, как high или как оба</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>{where}: low must lie below high</source>
            <translation>{where}: low должен лежать ниже high</translation>
        </message>
        <message>
            <location filename="../../core/archive/limits.py" />
            <source>is no TOML: {error}</source>
            <translation>не TOML: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>the same day</source>
            <translation>в тот же день</translation>
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
            <translation>на один день раньше</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>one day later</source>
            <translation>на один день позже</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>{count} days earlier</source>
            <translation>на {count} [день|дня|дней] раньше</translation>
        </message>
        <message>
            <location filename="../../core/archive/nearest.py" />
            <source>{count} days later</source>
            <translation>на {count} [день|дня|дней] позже</translation>
        </message>
        <message>
            <location filename="../../core/archive/noise_file.py" />
            <source>is no table: {error}</source>
            <translation>не является таблицей: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/noise_file.py" />
            <source>no line of coefficients: {error}</source>
            <translation>нет строки коэффициентов: {error}</translation>
        </message>
        <message>
            <location filename="../../core/archive/place.py" />
            <source>{root}: there is no such folder; nothing is changed: connect the disk, or name the folder of your sessions</source>
            <translation>{root}: такой папки нет; ничего не изменено: подключите диск или укажите папку ваших сеансов</translation>
        </message>
        <message>
            <location filename="../../core/archive/place.py" />
            <source>id is empty</source>
            <translation>id пуст</translation>
        </message>
        <message>
            <location filename="../../core/archive/reading.py" />
            <source>is too large for a table of means</source>
            <translation>слишком велик для таблицы средних</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>its raw bytes were not recorded</source>
            <translation>его необработанные байты не записаны</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>its raw log {name} is not there</source>
            <translation>его необработанного журнала {name} нет</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>its bytes hold no samples</source>
            <translation>его байты не содержат отсчётов</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>holds the samples {index} to {index2}, and {first} was accumulated</source>
            <translation>содержит отсчёты от {index} до {index2}, а накоплено было {first}</translation>
        </message>
        <message>
            <location filename="../../core/archive/reprocess.py" />
            <source>today's decoder names none of its channels</source>
            <translation>сегодняшний декодер не называет ни одного из его каналов</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>{root}: another archive stands there now; nothing is changed: open the archive anew</source>
            <translation>{root}: теперь там другой архив; ничего не изменено: откройте архив заново</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>the archive holds nothing of the number {number}: list it anew</source>
            <translation>в архиве нет ничего с номером {number}: обновите список</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>{path} stands at the rig {name}, in its folder {path2}</source>
            <translation>{path} лежит на стенде {name}, в его папке {path2}</translation>
        </message>
        <message>
            <location filename="../../core/archive/store.py" />
            <source>{path}: is no longer there; refresh the archive</source>
            <translation>{path}: больше не существует; обновите архив</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>contact of the customer</source>
            <translation>контакт заказчика</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>serial number of the item</source>
            <translation>заводской номер изделия</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>condition of the item</source>
            <translation>состояние изделия</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>date of calibration</source>
            <translation>дата калибровки</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>date of issue</source>
            <translation>дата выдачи</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>ambient temperature</source>
            <translation>температура окружающей среды</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>uncertainty of the results</source>
            <translation>неопределённость результатов</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>what was changed, and why</source>
            <translation>что изменено и почему</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>{name}: "{text}" is no date; write it as 2026-03-31</source>
            <translation>{name}: «{text}» не является датой; пишите как 2026-03-31</translation>
        </message>
        <message>
            <location filename="../../core/certificates/certificate.py" />
            <source>{later} on {other}, before it was {name} on {text}</source>
            <translation>{later} {other}, раньше, чем {name} {text}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/conformity_json.py" />
            <source>pass, fail or undecided</source>
            <translation>соответствует, не соответствует или не решено</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>name of the laboratory</source>
            <translation>название лаборатории</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>address of the laboratory</source>
            <translation>адрес лаборатории</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>person who authorises</source>
            <translation>утверждающее лицо</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>standards and their traceability</source>
            <translation>эталоны и их прослеживаемость</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>{name}: "{valid_until}" is no date; write it as 2026-03-31</source>
            <translation>{name}: «{valid_until}» не является датой; пишите как 2026-03-31</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>not stated: {words}; what does not apply stays an empty text</source>
            <translation>не указано: {words}; что не относится, остаётся пустым текстом</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>the pattern {number} has no n</source>
            <translation>в шаблоне {number} нет n</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>{name}: its certificate was valid until {until}, not on {day}</source>
            <translation>{name}: его сертификат был действителен до {until}, а не на {day}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>a text</source>
            <translation>текст</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>the pattern {number} cannot be filled</source>
            <translation>шаблон {number} невозможно заполнить</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory.py" />
            <source>{name}: no certificate is named, so that nothing can be traced</source>
            <translation>{name}: сертификат не назван, поэтому проследить ничего нельзя</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory_file.py" />
            <source>{path}: is there already, and is not written over; name another file</source>
            <translation>{path}: уже есть и не перезаписывается; назовите другой файл</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory_file.py" />
            <source>is not there; the window keeps it beside the sessions, and calrig certificate --template laboratory.toml writes one to be filled in</source>
            <translation>нет; окно держит его рядом с сеансами, а calrig certificate --template laboratory.toml пишет такой для заполнения</translation>
        </message>
        <message>
            <location filename="../../core/certificates/laboratory_file.py" />
            <source>not known: {join}; known are {join2}, and of [[standards]] {join3}</source>
            <translation>неизвестно: {join}; известны {join2}, а для [[standards]] {join3}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/order_file.py" />
            <source>a number above zero</source>
            <translation>число больше нуля</translation>
        </message>
        <message>
            <location filename="../../core/certificates/order_file.py" />
            <source>{where}: {key} is not known; known are {join}</source>
            <translation>{where}: {key} неизвестен; известны {join}</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{folder}: no number is free after {attempts} attempts</source>
            <translation>{folder}: после {attempts} [попытки|попыток|попыток] нет свободного номера</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{twin}: there is no such certificate</source>
            <translation>{twin}: такого сертификата нет</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{path}: the certificate was withdrawn before</source>
            <translation>{path}: сертификат уже отозван</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{path}: cannot be written ({strerror})</source>
            <translation>{path}: невозможно записать ({strerror})</translation>
        </message>
        <message>
            <location filename="../../core/certificates/register.py" />
            <source>{path}: the certificate cannot be kept ({strerror})</source>
            <translation>{path}: сертификат невозможно сохранить ({strerror})</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/advise.py" />
            <source>{why}; tells apart {join}</source>
            <translation>{why}; различает {join}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Where they differ most, {len} positions</source>
            <translation>Где они различаются больше всего, положений: {len}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>angles at which the tied effects read most differently, each twice, in mixed order</source>
            <translation>углы, при которых неразличимые эффекты дают самые разные показания, каждый дважды, в смешанном порядке</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>All mountings twice, twice as dense</source>
            <translation>Все установки дважды, вдвое гуще</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rig, dial and sensor apart, and marks between those of the first plan</source>
            <translation>стенд, лимб и датчик порознь, и отметки между теми, что в первом плане</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Reversed sweep</source>
            <translation>Проход в обратном направлении</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same angles the other way round</source>
            <translation>те же углы в обратном порядке</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Mixed sweep</source>
            <translation>Проход вперемешку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same angles in mixed order</source>
            <translation>те же углы в смешанном порядке</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Unit re-indexed by 90 deg</source>
            <translation>Изделие повёрнуто на 90 deg</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the dial errs at other attitudes</source>
            <translation>лимб имеет погрешности в других положениях</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Unit end for end</source>
            <translation>Изделие концами наоборот</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>errors of the rig turn their sign</source>
            <translation>погрешности стенда меняют знак</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Back to the first mounting</source>
            <translation>Назад к первой установке</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>what goes with time is not what came by bolting</source>
            <translation>то, что меняется со временем, — не то, что пришло от закрепления</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>End for end, and re-indexed</source>
            <translation>Концами наоборот и с поворотом</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rig, dial and sensor apart</source>
            <translation>стенд, лимб и датчик порознь</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>All mountings, mixed</source>
            <translation>Все установки, вперемешку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>All mountings twice, mixed</source>
            <translation>Все установки дважды, вперемешку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rig, dial and sensor apart, with half the noise</source>
            <translation>стенд, лимб и датчик порознь, с вдвое меньшим шумом</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Mixed rates</source>
            <translation>Скорости вперемешку</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same rates in mixed order</source>
            <translation>те же скорости в смешанном порядке</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Mixed rates twice</source>
            <translation>Скорости вперемешку дважды</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same rates in mixed order, twice</source>
            <translation>те же скорости в смешанном порядке, дважды</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Falling rates</source>
            <translation>Убывающие скорости</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>the same rates downwards</source>
            <translation>те же скорости по убыванию</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Rates between</source>
            <translation>Промежуточные скорости</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rates between those that were measured</source>
            <translation>скорости между уже измеренными</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>Small rates</source>
            <translation>Малые скорости</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>rates close to zero</source>
            <translation>скорости около нуля</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>{axis} along the shaft</source>
            <translation>{axis} вдоль вала</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/followups.py" />
            <source>another cross axis is vertical</source>
            <translation>вертикальна другая поперечная ось</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>These rows cannot tell: {why}.</source>
            <translation>Эти строки не дают ответа: {why}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>{shape} rows for {shape2} parameters leave nothing that could contradict the model; measure more positions, and each twice</source>
            <translation>{shape} [строка|строки|строк] на {shape2} [параметр|параметра|параметров] не оставляют ничего, что могло бы противоречить модели; измерьте больше положений, и каждое дважды</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>these rows cannot show {identifier}</source>
            <translation>эти строки не могут показать {identifier}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/ladder.py" />
            <source>any further effect</source>
            <translation>любой дальнейший эффект</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>{channels}: {len} rows for the {shape} parameters of the plain model; add positions</source>
            <translation>{channels}: {len} [строка|строки|строк] на {shape} [параметр|параметра|параметров] простой модели; добавьте положения</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>a run of test {test} is not compared; {join} are</source>
            <translation>серия испытания {test} не сравнивается; сравниваются {join}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>row {row}, {channels}: the output is not a number; leave the row out or measure it again</source>
            <translation>строка {row}, {channels}: выход не является числом; исключите строку или измерьте её снова</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>local gravity is not stated; {x} m/s^2 is taken, which changes the scale factor alone</source>
            <translation>местное g не указано; взято {x} m/s^2, что меняет только масштабный коэффициент</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>{name} is left out: its own input never changes in these rows; add positions</source>
            <translation>{name} пропущен: его собственный вход в этих строках не меняется; добавьте положения</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/problem.py" />
            <source>{channels}: the input along {axis} does not change; add positions</source>
            <translation>{channels}: вход вдоль {axis} не меняется; добавьте положения</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>The gap goes from {gap} to {gap2} noise floors.</source>
            <translation>Расхождение уменьшается с {gap} до {gap2} уровней шума.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>there is no output {channel}; there are: {join}</source>
            <translation>выхода {channel} нет; есть: {join}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>A constant explains the record; its scatter is {scatter}.</source>
            <translation>Запись объясняет постоянная; её разброс {scatter}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>No effect stands out, but the bias wanders far more than in sensors of this kind: it is {scatter}, or something that the catalogue does not know.</source>
            <translation>Ни один эффект не выделяется, но нулевой сигнал блуждает намного сильнее, чем у датчиков этого вида: это {scatter} или что-то, чего каталог не знает.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>Missing in the model: {named}. {closing} The rest is {scatter}.</source>
            <translation>Модели недостаёт: {named}. {closing} Остаток — {scatter}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>The data are at fault: {named}. The rest is {scatter}.</source>
            <translation>Виноваты данные: {named}. Остаток — {scatter}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>Something is missing, and this record cannot tell which of several effects: {tied}. {closing}</source>
            <translation>Чего-то недостаёт, и эта запись не решает, какого из нескольких эффектов: {tied}. {closing}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>a run of test {test} is no record</source>
            <translation>серия испытания {test} не является записью</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>with {lower}</source>
            <translation>с {lower}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>the noise floor is from the record itself: noise slower than a part of the record is known from sensors of this kind only</source>
            <translation>уровень шума взят из самой записи: шум медленнее части записи известен только по датчикам этого вида</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>This record cannot tell: {why}.</source>
            <translation>Эта запись не даёт ответа: {why}.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>There is structure that no effect of the catalogue explains:</source>
            <translation>Есть структура, которой не объясняет ни один эффект каталога:</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>the bias wanders several times as much as in sensors of this kind: noise of this unit, or a cause that is not in the catalogue; a second record tells, for noise goes another way then</source>
            <translation>нулевой сигнал блуждает в несколько раз сильнее, чем у датчиков этого вида: шум этого изделия или причина, которой нет в каталоге; это покажет вторая запись, ибо шум тогда пойдёт иначе</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record.py" />
            <source>named, not yet confirmed: only another record, with temperature and time going otherwise, confirms it</source>
            <translation>назван, ещё не подтверждён: подтвердит только другая запись, в которой температура и время идут иначе</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{lost} of {int} samples never came, in {int2} gaps of up to {longest} s</source>
            <translation>{lost} из {int} [отсчёта|отсчётов|отсчётов] не пришли, в {int2} пропусках до {longest} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{int} samples in succession are equal to the last bit, from {at} s on</source>
            <translation>{int} [отсчёт|отсчёта|отсчётов] подряд одинаковы до последнего бита, от {at} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{int} codes of {bit} {unit} never occur, where about {mean} samples each were to be expected</source>
            <translation>{int} [код|кода|кодов] по {bit} {unit} не встречаются ни разу, где ожидалось около {mean} [отсчёта|отсчётов|отсчётов] на каждый</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>the scatter is {ratio} times as large as elsewhere in {len} stretches, the first from {rows} s on</source>
            <translation>разброс в {ratio} [раз|раза|раз] больше, чем в других местах, на {len} участках, первый от {rows} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>{len} samples lie off, the farthest by {rest} sigma at {t_s} s</source>
            <translation>{len} [отсчёт|отсчёта|отсчётов] выпадают, дальше всех на {rest} сигм при {t_s} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_facts.py" />
            <source>the temperature is {value} degC to the last bit in {int} samples in succession from {at} s on</source>
            <translation>температура равна {value} °C до последнего бита в {int} отсчётах подряд от {at} s</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Another record right behind this one</source>
            <translation>Ещё одна запись сразу за этой</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>what settles has settled then, what drifts goes on, what jumped stays</source>
            <translation>то, что устанавливается, тогда уже установилось, то, что дрейфует, продолжается, то, что скачком изменилось, остаётся</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Restart from cold</source>
            <translation>Запуск из холодного состояния</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>what settles after switching on begins anew, what drifts goes on</source>
            <translation>то, что устанавливается после включения, начнётся снова, то, что дрейфует, продолжится</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Temperature held after a warm-up of an hour</source>
            <translation>Постоянная температура после часа прогрева</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>nothing that goes with temperature or with switching on is left</source>
            <translation>не остаётся ничего, что следует за температурой или включением</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Temperature up and down by {span_c} degC at {rate} degC/min</source>
            <translation>Температура вверх и вниз на {span_c} °C со скоростью {rate} °C/min</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>both directions and a rest between tell lag, hysteresis, slope and time apart</source>
            <translation>оба направления с паузой между ними различают запаздывание, гистерезис, наклон и время</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>Drive amplitude {drive} % higher for a third of the record</source>
            <translation>Амплитуда возбуждения на {drive} % больше в течение трети записи</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>what goes with the drive steps, what goes with temperature or time does not</source>
            <translation>то, что следует за возбуждением, скачком изменится, а то, что следует за температурой или временем, — нет</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>as before</source>
            <translation>как раньше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>on, temperature held</source>
            <translation>включено, температура постоянна</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>temperature held</source>
            <translation>температура постоянна</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_followups.py" />
            <source>up by {span_c} degC</source>
            <translation>вверх на {span_c} °C</translation>
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
            <translation>амплитуда без изменений</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>{len} blocks of {size} samples hold enough samples; record longer</source>
            <translation>{len} [блок|блока|блоков] по {size} отсчётов вмещают достаточно; записывайте дольше</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>{len} samples are no record; record at least {fewest_samples}</source>
            <translation>{len} [отсчёт|отсчёта|отсчётов] — не запись; запишите не менее {fewest_samples}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>the times of some rows are missing; state the samples per second</source>
            <translation>в некоторых строках нет времени; укажите число отсчётов в секунду</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>time runs backwards at sample {at}: two records were joined, take one</source>
            <translation>время идёт назад на отсчёте {at}: соединены две записи, возьмите одну</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>the samples are not uniform in time; use the counter of the device, or resample</source>
            <translation>отсчёты неравномерны во времени; воспользуйтесь счётчиком устройства или пересчитайте отсчёты</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>only {int} samples of {channels} are numbers</source>
            <translation>только {int} [отсчёт|отсчёта|отсчётов] {channels} являются числами</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>all samples of {channels} are equal: it is stuck or not connected</source>
            <translation>все отсчёты {channels} одинаковы: канал завис или не подключён</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>any effect of a record</source>
            <translation>любой эффект записи</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/record_problem.py" />
            <source>any effect of time</source>
            <translation>любой эффект времени</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/row_facts.py" />
            <source>all {len} rows of {minutes} min have the same temperature to the last digit, {values} degC: it does not come from the thermometer of the unit; effects of temperature cannot be judged</source>
            <translation>все {len} [строка|строки|строк] за {minutes} min имеют температуру {values} °C, одинаковую до последней цифры: она не от термометра изделия; об эффектах температуры судить нельзя</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>there is structure in {name} that no effect of the catalogue explains</source>
            <translation>в {name} есть структура, которой не объясняет ни один эффект каталога</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>{text}: the output goes to and fro between two levels, {abs} {unit} apart, {changes} times</source>
            <translation>{text}: выход переходит между двумя уровнями с разницей {abs} {unit}, переходов: {changes}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>look at the rig and the sensor where the curve is largest</source>
            <translation>осмотрите стенд и датчик там, где кривая наибольшая</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>measure more densely where the curve is largest</source>
            <translation>измеряйте гуще там, где кривая наибольшая</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>{text}: a smooth curve of {size} {unit} rms describes it, largest ({curve} {unit2}) at {worst} {unit3}</source>
            <translation>{text}: её описывает плавная кривая с СКО {size} {unit}, наибольшая ({curve} {unit2}) при {worst} {unit3}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>a smooth curve</source>
            <translation>плавная кривая</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/steps.py" />
            <source>two levels</source>
            <translation>два уровня</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>The model explains the data: the gap is {gap} noise floors. What these rows could have shown is listed.</source>
            <translation>Модель объясняет данные: расхождение {gap} уровней шума. То, что эти строки могли бы показать, перечислено.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>Missing in the model: {named}. {closing}</source>
            <translation>Модели недостаёт: {named}. {closing}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>The data are at fault: {named}. {closing}</source>
            <translation>Виноваты данные: {named}. {closing}</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>No effect stands out, but the noise is {gap} times what is stated, or a part of it is.</source>
            <translation>Ни один эффект не выделяется, но шум в {gap} [раз|раза|раз] больше указанного, или его часть.</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>the noise floor is from {told}; measure every position twice</source>
            <translation>уровень шума взят из {told}; измерьте каждое положение дважды</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>the part {name} of the noise is {ratio} times what is stated or usual</source>
            <translation>составляющая шума {name} в {ratio} [раз|раза|раз] больше указанной или обычной</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>a wrong value of g, a common error of all angles and a tilt seen through one mounting alone hide in scale factor, misalignment and bias; no number of rows shows them</source>
            <translation>неверное значение g, общая погрешность всех углов и наклон, видимый лишь в одной установке, прячутся в масштабном коэффициенте, несоосности и нулевом сигнале; никакое число строк их не покажет</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>an error of the table's speed in proportion to the rate hides in the scale factor; only its period shows it</source>
            <translation>погрешность скорости стола, пропорциональная скорости, прячется в масштабном коэффициенте; её покажет только период вращения</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>temperatures count from {mean} degC</source>
            <translation>температуры отсчитываются от {mean} °C</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>named, not yet confirmed: only a new series with other angles or order confirms it</source>
            <translation>назван, но ещё не подтверждён: подтвердит только новая серия с другими углами или порядком</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>Something is missing, and these data cannot tell which of several effects:</source>
            <translation>Чего-то недостаёт, и эти данные не решают, какого из нескольких эффектов:</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>standard errors and certificates, not from replicates</source>
            <translation>стандартных погрешностей и сертификатов, не из повторений</translation>
        </message>
        <message>
            <location filename="../../core/discrepancy/verdict.py" />
            <source>the residuals alone, for neither replicates nor standard errors are there</source>
            <translation>самих остатков, ибо нет ни повторений, ни стандартных погрешностей</translation>
        </message>
        <message>
            <location filename="../../core/errors.py" />
            <source>not determined: {join}; {why}</source>
            <translation>не определено: {join}; {why}</translation>
        </message>
        <message>
            <location filename="../../core/fit/design.py" />
            <source>the input that {which} respond to is not known in every row</source>
            <translation>вход, на который реагируют {which}, известен не в каждой строке</translation>
        </message>
        <message>
            <location filename="../../core/fit/design.py" />
            <source>{x} rows of these positions determine {rank} of {x2} parameters; measure positions in which the missing axes change, or fit fewer parameters</source>
            <translation>{x} [строка|строки|строк] этих положений определяют {rank} из {x2} [параметра|параметров|параметров]; измерьте положения, в которых меняются недостающие оси, или оценивайте меньше параметров</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>the uncertainties allow for it; the unit drifts between accumulations, positions were set worse than stated, or the model lacks something</source>
            <translation>неопределённости это учитывают; изделие дрейфует между накоплениями, положения установлены хуже, чем указано, или модели чего-то недостаёт</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>all uncertainties were enlarged by that factor, and the model lacks something</source>
            <translation>все неопределённости увеличены во столько же раз, и модели чего-то недостаёт</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>the residuals are {sqrt} times larger than the stated uncertainties of the rows allow (p = {p_value}); {meaning}</source>
            <translation>остатки в {sqrt} [раз|раза|раз] больше, чем допускают указанные неопределённости строк (p = {p_value}); {meaning}</translation>
        </message>
        <message>
            <location filename="../../core/fit/lack.py" />
            <source>repeated positions agree to {pure_sd} but the model misses the means by more (F = {statistic}, p = {p_value}): the model lacks something</source>
            <translation>повторённые положения совпадают в пределах {pure_sd}, но модель отклоняется от средних сильнее (F = {statistic}, p = {p_value}): модели чего-то недостаёт</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>only {told} of {x} rows bring a usable standard error; none is used, and the scatter of the residuals stands for all</source>
            <translation>только {told} из {x} [строки|строк|строк] имеют пригодную стандартную погрешность; ни одна не использована, за всё отвечает разброс остатков</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>{x} rows for {x2} parameters leave no residual that could show the drift between accumulations, and the intervals do not allow for it; repeat positions</source>
            <translation>{x} [строка|строки|строк] на {x2} [параметр|параметра|параметров] не оставляют остатка, который показал бы дрейф между накоплениями, и интервалы его не учитывают; повторите положения</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>{x} rows for {x2} parameters leave no degree of freedom: the numbers have no uncertainty and nothing can contradict them; repeat positions</source>
            <translation>{x} [строка|строки|строк] на {x2} [параметр|параметра|параметров] не оставляют степени свободы: у чисел нет неопределённости, и ничто не может им противоречить; повторите положения</translation>
        </message>
        <message>
            <location filename="../../core/fit/linear.py" />
            <source>row {bad}: the output is not a number</source>
            <translation>строка {bad}: выход не является числом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>the output does not vanish at zero input</source>
            <translation>выход не исчезает при нулевом входе</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>how much the output changes per unit of input</source>
            <translation>насколько меняется выход на единицу входа</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>k_i * input_i</source>
            <translation>k_i * input_i</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>Cross-axis sensitivity</source>
            <translation>Перекрёстная чувствительность</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>the sensor also feels the two other axes, mostly because it stands askew</source>
            <translation>датчик чувствует и две другие оси, большей частью потому, что стоит с перекосом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/common.py" />
            <source>k_ij * input_j + k_ik * input_k</source>
            <translation>k_ij * input_j + k_ik * input_k</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one accumulation was disturbed</source>
            <translation>одно накопление было нарушено</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>e at one row</source>
            <translation>e в одной строке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one row lies off</source>
            <translation>одна строка выпадает</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>look at the raw samples of this row; measure it again</source>
            <translation>посмотрите необработанные отсчёты этой строки; измерьте её снова</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Wrong angle</source>
            <translation>Неверный угол</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>the head stood at another angle than written</source>
            <translation>головка стояла на другом угле, чем записано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>U(angle + d) - U(angle) at one row</source>
            <translation>U(угол + d) - U(угол) в одной строке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one row lies off in all sensors, as one angle explains</source>
            <translation>одна строка выпадает во всех датчиках так, как это объясняет один угол</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>correct the angle if it is a whole step of the dial, else measure the row again</source>
            <translation>исправьте угол, если это целый шаг лимба, иначе измерьте строку снова</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Wrong stop</source>
            <translation>Неверная остановка</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>at one position the head stood wrong in every run</source>
            <translation>в одном положении головка каждый раз стояла неверно</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>U(angle + d) - U(angle) at one position</source>
            <translation>U(угол + d) - U(угол) в одном положении</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>all rows of one position lie off alike</source>
            <translation>все строки одного положения выпадают одинаково</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>check the stop or the division of the head there</source>
            <translation>проверьте упор или деление головки там</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Short accumulation</source>
            <translation>Короткое накопление</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one accumulation began too early or was too short</source>
            <translation>одно накопление началось слишком рано или было слишком коротким</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>rho * (U_previous - U) at one row</source>
            <translation>rho * (U_предыдущее - U) в одной строке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>one row lies off towards the row before, and its own scatter is large</source>
            <translation>одна строка отклоняется в сторону предыдущей, и её собственный разброс велик</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>look at the raw samples; wait longer; measure the row again</source>
            <translation>посмотрите необработанные отсчёты; ждите дольше; измерьте строку снова</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>Stuck reading</source>
            <translation>Застрявший отсчёт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>the reading of the row before was stored again, bit for bit</source>
            <translation>предыдущий отсчёт сохранён снова, бит в бит</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>a row that equals the row before exactly, at another setting</source>
            <translation>строка точно равна предыдущей при другой установке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/faults.py" />
            <source>measure the row again</source>
            <translation>измерьте строку снова</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro.py" />
            <source>Acceleration-sensitive drift</source>
            <translation>Дрейф от ускорения</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro.py" />
            <source>gravity and acceleration shift the zero of the gyro</source>
            <translation>сила тяжести и ускорение смещают нулевой сигнал гироскопа</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro.py" />
            <source>b_ix * a_x + b_iy * a_y + b_iz * a_z</source>
            <translation>b_ix * a_x + b_iy * a_y + b_iz * a_z</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>Magnetic sensitivity</source>
            <translation>Магнитная чувствительность</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the magnetic field of the building shifts the output</source>
            <translation>магнитное поле здания смещает выход</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>m_s * (own axis along the shaft) + m_l * (own axis level across it)</source>
            <translation>m_s * (собственная ось вдоль вала) + m_l * (собственная ось горизонтально поперёк)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the harmonics of g-sensitivity, but fixed to the building</source>
            <translation>гармоники g-чувствительности, но привязанные к зданию</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>turn the head by 180 degrees in azimuth; shield the unit</source>
            <translation>поверните головку на 180 градусов по азимуту; экранируйте изделие</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>g-squared-sensitive drift</source>
            <translation>дрейф от квадрата g</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the square of the acceleration shifts the zero of the gyro</source>
            <translation>квадрат ускорения смещает нулевой сигнал гироскопа</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>b_ij * a_i * a_j</source>
            <translation>b_ij * a_i * a_j</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>second harmonic of the head angle</source>
            <translation>вторая гармоника угла головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>measure between the quarter turns; calibrate with the products</source>
            <translation>измеряйте между четвертями оборота; калибруйте с произведениями</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>Earth rate</source>
            <translation>Вращение Земли</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>the gyro feels the rotation of the Earth</source>
            <translation>гироскоп чувствует вращение Земли</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>k * (W_up * up + W_north * north)</source>
            <translation>k * (W_верт * вверх + W_север * север)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>exactly what g-sensitivity looks like, as long as the head keeps its azimuth</source>
            <translation>в точности то, как выглядит g-чувствительность, пока головка сохраняет азимут</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/gyro_static.py" />
            <source>compute it from the latitude; turn the head by 180 degrees in azimuth</source>
            <translation>вычислите его по широте; поверните головку на 180 градусов по азимуту</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>the output depends on whether the input rose or fell before</source>
            <translation>выход зависит от того, рос или убывал вход перед этим</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>k * h * sign(x - x_previous)</source>
            <translation>k * h * sign(x - x_предыдущее)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>runs with rising and with falling input lie apart</source>
            <translation>серии с ростом и убыванием входа расходятся</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>approach all positions from one side, or state the two branches</source>
            <translation>подходите ко всем положениям с одной стороны или укажите две ветви</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>Settling lag</source>
            <translation>Запаздывание установления</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>a part of the way from the position before is still missing</source>
            <translation>части пути от предыдущего положения ещё недостаёт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>rho * (U_previous - U)</source>
            <translation>rho * (U_предыдущее - U)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>residuals follow the step from the position before</source>
            <translation>остатки повторяют шаг от предыдущего положения</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/history.py" />
            <source>wait longer before each accumulation</source>
            <translation>ждите дольше перед каждым накоплением</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Second-order nonlinearity K2</source>
            <translation>Нелинейность второго порядка K2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the output bends the same way at both ends of the range</source>
            <translation>выход изгибается одинаково на обоих концах диапазона</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a parabola against the input; second harmonic of the head angle</source>
            <translation>парабола в зависимости от входа; вторая гармоника угла головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the square term; on a rate table also try another radius</source>
            <translation>калибруйте с квадратичным членом; на поворотном столе попробуйте также другой радиус</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Third-order nonlinearity K3</source>
            <translation>Нелинейность третьего порядка K3</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the output bends in opposite ways at the two ends of the range</source>
            <translation>выход изгибается противоположно на двух концах диапазона</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>an S against the input; third harmonic of the head angle</source>
            <translation>S-образная зависимость от входа; третья гармоника угла головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the cubic term</source>
            <translation>калибруйте с кубическим членом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Odd quadratic nonlinearity</source>
            <translation>Нечётная квадратичная нелинейность</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the sensitivity grows with the size of the input, alike to both sides</source>
            <translation>чувствительность растёт с величиной входа, одинаково в обе стороны</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * Ko * x * |x|</source>
            <translation>k * Ko * x * |x|</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>an S against the input that is steeper in the middle than a cube</source>
            <translation>S-образная зависимость от входа, круче посередине, чем куб</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the term x|x|; more than 1 g tells it from the cube</source>
            <translation>калибруйте с членом x|x|; более 1 g отличает его от куба</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Cross-axis nonlinearity Koo, Kpp</source>
            <translation>Поперечная нелинейность Koo, Kpp</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the square of the acceleration across the input axis shifts the output</source>
            <translation>квадрат ускорения поперёк входной оси смещает выход</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * (Kxx * a_x^2 + Kyy * a_y^2)</source>
            <translation>k * (Kxx * a_x^2 + Kyy * a_y^2)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the bias depends on which cross axis is vertical</source>
            <translation>нулевой сигнал зависит от того, какая поперечная ось вертикальна</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the square of the cross axis; mount another axis along the shaft</source>
            <translation>калибруйте с квадратом поперечной оси; установите другую ось вдоль вала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Cross-coupling Kio, Kip, Kpo</source>
            <translation>Перекрёстная связь Kio, Kip, Kpo</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the product of the accelerations along two axes shifts the output</source>
            <translation>произведение ускорений вдоль двух осей смещает выход</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * (kxy * a_x a_y + kxz * a_x a_z + kyz * a_y a_z)</source>
            <translation>k * (kxy * a_x a_y + kxz * a_x a_z + kyz * a_y a_z)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>second harmonic of the head angle, largest between the quarter turns</source>
            <translation>вторая гармоника угла головки, наибольшая между четвертями оборота</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate with the product term; quarter turns alone never show it</source>
            <translation>калибруйте с членом-произведением; одни лишь четверти оборота его никогда не покажут</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Scale-factor asymmetry</source>
            <translation>Асимметрия масштабного коэффициента</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the sensitivity to the positive side is another one than to the negative side</source>
            <translation>чувствительность в положительную сторону иная, чем в отрицательную</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a V against the input, its kink at zero</source>
            <translation>V-образная зависимость от входа с изломом в нуле</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>calibrate the two sides apart; dense points near zero tell it from K2</source>
            <translation>калибруйте обе стороны отдельно; густые точки около нуля отличают её от K2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Bias asymmetry K0'</source>
            <translation>Асимметрия нулевого сигнала K0'</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>the bias on the positive side is another one than on the negative side</source>
            <translation>нулевой сигнал с положительной стороны иной, чем с отрицательной</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>k * K0' * sign(x) / 2</source>
            <translation>k * K0' * sign(x) / 2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a jump where the input changes its sign</source>
            <translation>скачок там, где вход меняет знак</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>look for a dead band of the electronics; measure close to zero</source>
            <translation>ищите зону нечувствительности электроники; измеряйте около нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>Dead band</source>
            <translation>Зона нечувствительности</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>small rates are not answered, and all larger ones by so much too little</source>
            <translation>на малые скорости ответа нет, а на все большие он на столько же меньше</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>-k * D * sign(w)</source>
            <translation>-k * D * sign(w)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>a step at zero rate</source>
            <translation>ступенька при нулевой скорости</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>look for lost motion in the drive of the table; measure small rates</source>
            <translation>ищите люфт в приводе стола; измерьте малые скорости</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>beyond a level the output grows less than it should</source>
            <translation>выше некоторого уровня выход растёт меньше, чем должен</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>-k * s * (|x| - c) beyond c</source>
            <translation>-k * s * (|x| - c) свыше c</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>flat ends of the characteristic</source>
            <translation>плоские концы характеристики</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/nonlinear.py" />
            <source>keep the input below the level; look at the limits of the converter</source>
            <translation>держите вход ниже этого уровня; проверьте пределы преобразователя</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Temperature-rate sensitivity</source>
            <translation>Чувствительность к скорости изменения температуры</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias follows how fast the temperature changes</source>
            <translation>нулевой сигнал зависит от того, как быстро меняется температура</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bR * dT/dt</source>
            <translation>bR * dT/dt</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>an offset while it warms, the opposite one while it cools</source>
            <translation>сдвиг при нагреве, противоположный при охлаждении</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>change the temperature more slowly, or compensate by dT/dt</source>
            <translation>меняйте температуру медленнее или компенсируйте по dT/dt</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Thermal lag</source>
            <translation>Тепловое запаздывание</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias follows a part whose temperature lags behind the thermometer's</source>
            <translation>нулевой сигнал зависит от части, температура которой отстаёт от термометра</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bL * (T lagged by tau)</source>
            <translation>bL * (T с запаздыванием tau)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>a loop against temperature, wider when it changes faster</source>
            <translation>петля по температуре, шире при более быстром изменении</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>wait for balance; compensate by the lagged temperature; move the thermometer</source>
            <translation>ждите равновесия; компенсируйте по запаздывающей температуре; перенесите термометр</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Thermal hysteresis</source>
            <translation>Тепловой гистерезис</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>warming and cooling leave another bias at the same temperature, however slowly</source>
            <translation>нагрев и охлаждение оставляют разный нулевой сигнал при той же температуре, как бы медленно ни шли</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bH * (T - play(T)) / half width</source>
            <translation>bH * (T - люфт(T)) / полуширина</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>two branches against temperature that slow changes do not close</source>
            <translation>две ветви по температуре, которые не смыкаются при медленных изменениях</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>approach temperatures from one side; state the two branches</source>
            <translation>подходите к температурам с одной стороны; укажите две ветви</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>residuals follow this channel</source>
            <translation>остатки повторяют этот канал</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Quadrature leakage</source>
            <translation>Просачивание квадратуры</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>a part of the quadrature signal gets into the rate</source>
            <translation>часть квадратурного сигнала попадает в скорость</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bQ * (Q - Q0)</source>
            <translation>bQ * (Q - Q0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>adjust the phase of the demodulator; compensate by the quadrature channel</source>
            <translation>настройте фазу демодулятора; компенсируйте по каналу квадратуры</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Demodulation phase error</source>
            <translation>Погрешность фазы демодуляции</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the phase of the demodulator moves and lets quadrature through</source>
            <translation>фаза демодулятора плывёт и пропускает квадратуру</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bF * (phi - phi0) * Q</source>
            <translation>bF * (phi - phi0) * Q</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>stabilise the phase loop; reduce the quadrature; compensate by the product</source>
            <translation>стабилизируйте фазовую петлю; уменьшите квадратуру; компенсируйте по произведению</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Damping anisotropy</source>
            <translation>Анизотропия демпфирования</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>damping differs by direction, so that the excitation gets into the rate</source>
            <translation>демпфирование зависит от направления, поэтому возбуждение попадает в скорость</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bE * (E - E0)</source>
            <translation>bE * (E - E0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>compensate by the excitation channel; stabilise the temperature</source>
            <translation>компенсируйте по каналу возбуждения; стабилизируйте температуру</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Resonator frequency</source>
            <translation>Частота резонатора</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias follows the period of the resonator, a thermometer inside it</source>
            <translation>нулевой сигнал зависит от периода резонатора, термометра внутри него самого</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bP * (P - P0)</source>
            <translation>bP * (P - P0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>compensate by the period instead of the thermometer</source>
            <translation>компенсируйте по периоду вместо термометра</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Amplitude error</source>
            <translation>Погрешность амплитуды</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the amplitude of the vibration is not held, and the bias follows it</source>
            <translation>амплитуда колебаний не удерживается, и нулевой сигнал следует за ней</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>bA * (A - A0)</source>
            <translation>bA * (A - A0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>look at the amplitude control; compensate by the amplitude channel</source>
            <translation>проверьте стабилизацию амплитуды; компенсируйте по каналу амплитуды</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>Random telegraph bias</source>
            <translation>Телеграфный нулевой сигнал</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>the bias jumps to and fro between two levels</source>
            <translation>нулевой сигнал скачет между двумя уровнями</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>J * s(t), s = 0 or 1</source>
            <translation>J * s(t), s = 0 или 1</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>two levels against time</source>
            <translation>два уровня по времени</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record.py" />
            <source>look for a loose contact, popcorn noise of an amplifier, a latching loop</source>
            <translation>ищите плохой контакт, взрывной шум усилителя, защёлкивающуюся петлю</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>belongs to the sensor; state it in the noise model and average accordingly</source>
            <translation>принадлежит датчику; укажите его в модели шума и усредняйте соответственно</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Quantisation noise</source>
            <translation>Шум квантования</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the increments of angle are rounded coarsely</source>
            <translation>приращения угла грубо округлены</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = (2 pi f)^2 Q^2 dt</source>
            <translation>S(f) = (2 pi f)^2 Q^2 dt</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>slope -1 of the Allan deviation; the spectrum rises with f^2</source>
            <translation>наклон -1 девиации Аллана; спектр растёт как f^2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Angle random walk</source>
            <translation>Случайное блуждание угла</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>white noise of the rate</source>
            <translation>белый шум скорости</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>slope -1/2 of the Allan deviation; a flat spectrum</source>
            <translation>наклон -1/2 девиации Аллана; плоский спектр</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Bias instability</source>
            <translation>Нестабильность нуля</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>flicker noise: the mean never settles, however long it is taken</source>
            <translation>фликкер-шум: среднее никогда не устанавливается, сколько ни усредняй</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = B^2 / (2 pi f)</source>
            <translation>S(f) = B^2 / (2 pi f)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a floor of the Allan deviation; the spectrum rises with 1/f</source>
            <translation>дно девиации Аллана; спектр растёт как 1/f</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Rate random walk</source>
            <translation>Случайное блуждание скорости</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the bias walks at random</source>
            <translation>нулевой сигнал блуждает случайно</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = (K / 2 pi f)^2</source>
            <translation>S(f) = (K / 2 pi f)^2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>slope +1/2 of the Allan deviation; the spectrum rises with 1/f^2</source>
            <translation>наклон +1/2 девиации Аллана; спектр растёт как 1/f^2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Markov noise</source>
            <translation>Марковский шум</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the bias scatters about its mean with a memory of one length</source>
            <translation>нулевой сигнал колеблется около среднего с памятью одной длины</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>S(f) = 2 s^2 tau / (1 + (2 pi f tau)^2)</source>
            <translation>S(f) = 2 s^2 tau / (1 + (2 pi f tau)^2)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a hump of the Allan deviation at 1.89 tau</source>
            <translation>горб девиации Аллана при 1,89 tau</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>samples are missing</source>
            <translation>отсчётов недостаёт</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>gaps in the counter or the time</source>
            <translation>пропуски в счётчике или во времени</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>steps of time that are whole multiples of the sampling time</source>
            <translation>шаги времени, кратные интервалу дискретизации</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look at cable, speed of the port and load of the computer; record again</source>
            <translation>проверьте кабель, скорость порта и загрузку компьютера; запишите снова</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Missing codes</source>
            <translation>Отсутствующие коды</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the converter never gives some of its codes</source>
            <translation>преобразователь никогда не выдаёт некоторых своих кодов</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>empty codes between full ones</source>
            <translation>пустые коды между полными</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a comb in the histogram of the codes</source>
            <translation>гребёнка в гистограмме кодов</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look at the converter and at the scaling of its codes</source>
            <translation>проверьте преобразователь и масштаб его кодов</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Stale temperature</source>
            <translation>Застывшая температура</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the temperature stands still while it cannot</source>
            <translation>температура стоит, когда не может</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>T bit for bit the same</source>
            <translation>T бит в бит та же</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a run of equal temperatures far longer than chance</source>
            <translation>ряд одинаковых температур, намного длиннее случайного</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look at the thermometer; effects of temperature cannot be judged</source>
            <translation>проверьте термометр; об эффектах температуры судить нельзя</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>Variance burst</source>
            <translation>Всплеск дисперсии</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>the scatter was larger for a time</source>
            <translation>разброс некоторое время был больше</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>sigma larger from t1 to t2</source>
            <translation>сигма больше с t1 до t2</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a wide stretch of the record</source>
            <translation>широкий участок записи</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>look for vibration, steps, machines at that time; leave the stretch out</source>
            <translation>ищите вибрацию, шаги, машины в это время; не берите этот участок</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>samples pile up at an extreme value</source>
            <translation>отсчёты скапливаются на крайнем значении</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>more samples at the extreme than beside it</source>
            <translation>на крайнем значении больше отсчётов, чем рядом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>a flat top</source>
            <translation>плоская вершина</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_facts.py" />
            <source>choose a larger range; look for shocks</source>
            <translation>выберите больший диапазон; ищите удары</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/record_slow.py" />
            <source>bT * (T - T0) + bT2 * (T - T0)^2 ...</source>
            <translation>bT * (T - T0) + bT2 * (T - T0)^2 ...</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Positions swapped</source>
            <translation>Положения перепутаны</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>two positions were stored in each other's place</source>
            <translation>два положения сохранены одно вместо другого</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>rows i and j exchanged</source>
            <translation>строки i и j переставлены</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>two rows lie off, and exchanging them leaves nothing</source>
            <translation>две строки выпадают, а после их перестановки не остаётся ничего</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>exchange the two rows, or measure them again</source>
            <translation>переставьте две строки или измерьте их снова</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Mount reversed</source>
            <translation>Установка наоборот</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>in one mounting the unit stood the other way round than written</source>
            <translation>в одной установке изделие стояло наоборот, чем записано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>the head turned the other way in that mounting</source>
            <translation>в этой установке головка вращалась в другую сторону</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>the cross-axis sensitivity has another sign in one mounting</source>
            <translation>перекрёстная чувствительность имеет другой знак в одной установке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>correct the mount, or mount it as planned and repeat</source>
            <translation>исправьте установку или установите по плану и повторите</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Rate sign reversed</source>
            <translation>Знак скорости наоборот</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>the table turned the other way than written</source>
            <translation>стол вращался в другую сторону, чем записано</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>-w in a run or at a row</source>
            <translation>-w в серии или в строке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>rows on the line of the opposite slope</source>
            <translation>строки на прямой с противоположным наклоном</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>correct the sign</source>
            <translation>исправьте знак</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>Channels permuted</source>
            <translation>Каналы переставлены</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>outputs of the triad stand in each other's columns</source>
            <translation>выходы триады стоят не в своих столбцах</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>columns of y exchanged</source>
            <translation>столбцы y переставлены</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>a sensor answers to the axis of another one</source>
            <translation>датчик отвечает на ось другого</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/relabelling.py" />
            <source>correct the names of the columns</source>
            <translation>исправьте названия столбцов</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Mounting angle</source>
            <translation>Угол установки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>in one mounting the unit stands turned on the shaft by a small angle</source>
            <translation>в одной установке изделие повёрнуто на валу на малый угол</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>psi * dU/d(head angle) in that mounting</source>
            <translation>psi * dU/d(угол головки) в этой установке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the misalignment differs from mounting to mounting</source>
            <translation>несоосность различна в разных установках</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>align the unit on the fixture anew; mount it both ways round to tell it from k_zy</source>
            <translation>выровняйте изделие на оснастке заново; установите его обоими способами, чтобы отличить от k_zy</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Shaft tilt</source>
            <translation>Наклон вала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the shaft of the head, or the platform, is not level</source>
            <translation>вал головки или платформа не горизонтальны</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>eps * g * (response along the shaft)</source>
            <translation>eps * g * (чувствительность вдоль вала)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>an offset of each mounting, largest in the sensor along the shaft, turning its sign</source>
            <translation>сдвиг каждой установки, наибольший у датчика вдоль вала, меняющий знак</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>level the shaft; mount the unit both ways round</source>
            <translation>выровняйте вал; установите изделие обоими способами</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Re-mount bias</source>
            <translation>Сдвиг от переустановки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>bolting on shifted the bias</source>
            <translation>закрепление изменило нулевой сигнал</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>b in that mounting</source>
            <translation>b в этой установке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>an offset of one mounting, whichever way round</source>
            <translation>сдвиг одной установки, какой бы стороной ни стояло изделие</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>return to the first mounting at the end; torque the screws alike</source>
            <translation>в конце вернитесь к первой установке; затягивайте винты одинаково</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>certify the head; re-index the unit by 90 degrees on the dial and repeat</source>
            <translation>аттестуйте головку; переставьте изделие на 90 градусов на лимбе и повторите</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Head eccentricity</source>
            <translation>Эксцентриситет головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the dial sits off centre, so the angle is wrong once a turn</source>
            <translation>лимб сидит не по центру, поэтому угол неверен раз на оборот</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>dU/d(head angle) * e * sin(head angle - phase)</source>
            <translation>dU/d(угол головки) * e * sin(угол головки - фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>second harmonic of the head angle and a constant</source>
            <translation>вторая гармоника угла головки и постоянная</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Head ellipticity</source>
            <translation>Эллиптичность головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>the dial is out of round, so the angle is wrong twice a turn</source>
            <translation>лимб некруглый, поэтому угол неверен дважды на оборот</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>dU/d(head angle) * e * sin(2 head angle - phase)</source>
            <translation>dU/d(угол головки) * e * sin(2 угла головки - фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>first and third harmonic of the head angle</source>
            <translation>первая и третья гармоники угла головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>Head periodic error</source>
            <translation>Периодическая погрешность головки</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>worm or division make the angle wrong many times a turn</source>
            <translation>червяк или деления делают угол неверным много раз на оборот</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>dU/d(head angle) * e * sin(N head angle + phase)</source>
            <translation>dU/d(угол головки) * e * sin(N угол головки + фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/rig.py" />
            <source>a fast harmonic of the head angle that repeats in every run</source>
            <translation>быстрая гармоника угла головки, повторяющаяся в каждой серии</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Table slip</source>
            <translation>Проскальзывание стола</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>above a rate the drive of the table slips</source>
            <translation>выше некоторой скорости привод стола проскальзывает</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>-k * s * (|w| - w_s) * sign(w) above w_s</source>
            <translation>-k * s * (|w| - w_s) * sign(w) свыше w_s</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>both ends of the characteristic turn towards zero</source>
            <translation>оба конца характеристики загибаются к нулю</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>measure the period of the table; tighten the belt</source>
            <translation>измерьте период стола; натяните ремень</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Wrong speed at one setting</source>
            <translation>Неверная скорость при одной уставке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>at one setting the table runs at another speed than it says</source>
            <translation>при одной уставке стол вращается с другой скоростью, чем показывает</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>k * e at that setting</source>
            <translation>k * e при этой уставке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>all rows of one set rate lie off</source>
            <translation>все строки одной заданной скорости выпадают</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>measure the period of the table at this setting</source>
            <translation>измерьте период стола при этой уставке</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Wobble of the table</source>
            <translation>Биение стола</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>the axis of the table is tilted; what swings round does not average out</source>
            <translation>ось стола наклонена; то, что вращается вокруг, не усредняется</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>b * mean of sin and cos(w t) over the accumulation</source>
            <translation>b * среднее sin и cos(w t) за накопление</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>residuals at small rates that depend on the length of the accumulation</source>
            <translation>остатки при малых скоростях, зависящие от длительности накопления</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>accumulate over whole turns; level the table</source>
            <translation>накапливайте за целые обороты; выровняйте стол</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>Scale factor with amplitude</source>
            <translation>Масштабный коэффициент от амплитуды</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>the sensitivity of the vibratory gyro follows its drive amplitude</source>
            <translation>чувствительность вибрационного гироскопа зависит от амплитуды колебаний</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>slope of the characteristic changes with the amplitude</source>
            <translation>наклон характеристики меняется с амплитудой</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/table.py" />
            <source>look at the amplitude control; calibrate with the amplitude</source>
            <translation>проверьте стабилизацию амплитуды; калибруйте с амплитудой</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Bias drift</source>
            <translation>Дрейф нулевого сигнала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias goes steadily with time</source>
            <translation>нулевой сигнал равномерно меняется со временем</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a straight line against time</source>
            <translation>прямая линия по времени</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>wait until it has settled; repeat the first positions at the end</source>
            <translation>подождите, пока установится; повторите первые положения в конце</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Bias temperature sensitivity</source>
            <translation>Температурная чувствительность нулевого сигнала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias follows the temperature</source>
            <translation>нулевой сигнал следует за температурой</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>bT * (T - T0)</source>
            <translation>bT * (T - T0)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a straight line against temperature</source>
            <translation>прямая линия по температуре</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>calibrate over temperature; change the temperature on purpose by 10 degrees</source>
            <translation>калибруйте по температуре; намеренно измените температуру на 10 градусов</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Scale-factor temperature sensitivity</source>
            <translation>Температурная чувствительность масштабного коэффициента</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the sensitivity follows the temperature</source>
            <translation>чувствительность следует за температурой</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>k * kT * (T - T0) * x</source>
            <translation>k * kT * (T - T0) * x</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>slope of the characteristic changes with temperature</source>
            <translation>наклон характеристики меняется с температурой</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>calibrate over temperature; state T0 with the scale factor</source>
            <translation>калибруйте по температуре; указывайте T0 вместе с масштабным коэффициентом</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>after switching on the bias settles exponentially</source>
            <translation>после включения нулевой сигнал устанавливается по экспоненте</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>W * exp(-t / tau)</source>
            <translation>W * exp(-t / tau)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the first rows lie off and come closer</source>
            <translation>первые строки выпадают и приближаются</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>switch on earlier; begin when the temperature stands</source>
            <translation>включайте раньше; начинайте, когда температура установилась</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Bias jump</source>
            <translation>Скачок нулевого сигнала</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias jumped once and stayed</source>
            <translation>нулевой сигнал скачком изменился один раз и остался</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>J from one row on</source>
            <translation>J с одной строки и далее</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a step against time</source>
            <translation>ступенька по времени</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>repeat the test; look for a knock, a re-start, a change of the supply</source>
            <translation>повторите испытание; ищите удар, перезапуск, изменение питания</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Run-to-run bias</source>
            <translation>Нулевой сигнал от серии к серии</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the bias is another one in one run</source>
            <translation>в одной серии нулевой сигнал иной</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>b in that run</source>
            <translation>b в этой серии</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>one run lies off</source>
            <translation>одна серия выпадает</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>leave the unit powered between runs; state the turn-on repeatability</source>
            <translation>не выключайте изделие между сериями; укажите повторяемость включений</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Run-to-run scale factor</source>
            <translation>Масштабный коэффициент от серии к серии</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>the sensitivity is another one in one run</source>
            <translation>в одной серии чувствительность иная</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>k * s * x in that run</source>
            <translation>k * s * x в этой серии</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>one run has another slope</source>
            <translation>одна серия имеет другой наклон</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>leave the unit powered between runs; check the speed of the table</source>
            <translation>не выключайте изделие между сериями; проверьте скорость стола</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>Periodic pick-up</source>
            <translation>Периодическая наводка</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>something periodic in time is picked up</source>
            <translation>наводится что-то периодическое во времени</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>A * sin(2 pi f t + phase)</source>
            <translation>A * sin(2 pi f t + фаза)</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>a sine against time</source>
            <translation>синусоида по времени</translation>
        </message>
        <message>
            <location filename="../../core/model/catalogue/timeline.py" />
            <source>look for mains and motors; reverse a run, which tells it from an error of the head</source>
            <translation>ищите сеть питания и двигатели; обратите серию: это отличает наводку от погрешности головки</translation>
        </message>
        <message>
            <location filename="../../core/model/effect.py" />
            <source>{id} has {len} shape values, not {len2}</source>
            <translation>{id} имеет {len} [значение|значения|значений] формы, а не {len2}</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>local gravity must be a positive number in m/s^2, got {x}</source>
            <translation>местное ускорение силы тяжести должно быть положительным числом в m/s^2, получено {x}</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>row {missing}: the set rate is missing</source>
            <translation>строка {missing}: нет заданной скорости</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>the sensors look along {join}, and the run does not say which of these axes stood along the table's; give a mount, e.g. Z_from for Z up</source>
            <translation>датчики смотрят вдоль {join}, а серия не говорит, какая из этих осей стояла вдоль оси стола; укажите установку, напр. Z_from для Z вверх</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>the data hold no complete column {name}, which the model needs</source>
            <translation>в данных нет полного столбца {name}, нужного модели</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>row {row}: the head angle is missing</source>
            <translation>строка {row}: нет угла головки</translation>
        </message>
        <message>
            <location filename="../../core/model/stimulus.py" />
            <source>row {row}: {error}</source>
            <translation>строка {row}: {error}</translation>
        </message>
        <message>
            <location filename="../../core/plans/orientation.py" />
            <source>unknown mount {text}; expected X_from, X_to, Y_from, Y_to, Z_from or Z_to, optionally with a re-index angle such as X_from@90</source>
            <translation>неизвестная установка {text}; ожидается X_from, X_to, Y_from, Y_to, Z_from или Z_to, при необходимости с углом поворота, напр. X_from@90</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>the file</source>
            <translation>файл</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[plan] test = {test}; expected one of {join}</source>
            <translation>[plan] test = {test}; ожидается одно из {join}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>a plan needs at least one [[group]]</source>
            <translation>плану нужна хотя бы одна [[group]]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>step numbers used twice: {sorted}</source>
            <translation>номера шагов использованы дважды: {sorted}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[[group]] {title}: give either head_deg or rates_dps, a list of numbers</source>
            <translation>[[group]] {title}: дайте либо head_deg, либо rates_dps, список чисел</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[[group]] {title}: {len} numbers for {count} steps</source>
            <translation>[[group]] {title}: {len} [номер|номера|номеров] на {count} [шаг|шага|шагов]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>not TOML: {error}</source>
            <translation>не TOML: {error}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>a group is {group}; write it as a table [[group]]</source>
            <translation>группа — {group}; пишите её таблицей [[group]]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>[[group]] {title}: {error}</source>
            <translation>[[group]] {title}: {error}</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{where} needs a table [{key}]</source>
            <translation>{where}: нужна таблица [{key}]</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{key} is missing or no text</source>
            <translation>{key} отсутствует или не текст</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{key} must be a list of numbers</source>
            <translation>{key} должен быть списком чисел</translation>
        </message>
        <message>
            <location filename="../../core/plans/plan.py" />
            <source>{key} holds {item}, which is no number</source>
            <translation>{key} содержит {item}, что не является числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy.py" />
            <source>the run holds no rows</source>
            <translation>серия не содержит строк</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy.py" />
            <source>{device}: there are neither angles of the unit nor raw codes with a calibration</source>
            <translation>{device}: нет ни углов изделия, ни необработанных кодов с калибровкой</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the angles are {error} deg off the set ones: another list of angles, pitch taken for roll, or another mount?</source>
            <translation>углы отличаются на {error} deg от заданных: другой список углов, тангаж вместо крена или другая установка?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>{device} sends angles but no raw codes of its accelerometers: only its own angles are judged, none by a calibration</source>
            <translation>{device} передаёт углы, но не коды акселерометров: оцениваются только его собственные углы, без калибровки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>no calibration was chosen: only the unit's own angles are judged; calibrate it on the head to judge the raw codes</source>
            <translation>калибровка не выбрана: оцениваются только собственные углы изделия; откалибруйте его на головке, чтобы оценить коды</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the uncertainty of a head setting was not stated: the verdict counts noise and resolution only</source>
            <translation>неопределённость установки головки не указана: решение учитывает только шум и разрешение</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the angles follow the set ones with the opposite sign ({error} deg off as they are, {back} deg with the sign turned): the unit is mounted the other way round, or the head was turned the other way</source>
            <translation>углы повторяют заданные с противоположным знаком (разница {error} deg как есть, {back} deg с обращённым знаком): изделие установлено наоборот или головку вращали в другую сторону</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the calibration is of {name}, the angles were measured on {device}</source>
            <translation>калибровка относится к {name}, а углы измерены на {device}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>row {place}: the specific force is {in_mg} mg from g (u = {milli} mg): the sensors are no longer what they were when calibrated; another temperature or another day?</source>
            <translation>строка {place}: кажущееся ускорение отличается от g на {in_mg} mg (u = {milli} mg): датчики уже не такие, как при калибровке; другая температура или другой день?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_notes.py" />
            <source>the errors by the calibration are {times} times larger than its uncertainty and that of the head allow (p = {p_value}): the unit has changed, or it sits askew on the head (see the aligned errors)</source>
            <translation>погрешности по калибровке в {times} [раз|раза|раз] больше, чем допускают её неопределённость и неопределённость головки (p = {p_value}): изделие изменилось или стоит на головке с перекосом (см. выровненные погрешности)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>{title}: pitch is set with X along the shaft, roll with Y</source>
            <translation>{title}: тангаж задают с X вдоль вала, крен — с Y</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>a list of angles holds 1 to {most} of them, not {len}</source>
            <translation>список углов содержит от 1 до {most}, а не {len}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>the list is empty; write e.g. 0, 30, 60</source>
            <translation>список пуст; пишите, напр., 0, 30, 60</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>{word} is no angle from -360 to 360 deg</source>
            <translation>{word} не является углом от -360 до 360 deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_plan.py" />
            <source>{word} is no angle; write e.g. 0, 30, 60</source>
            <translation>{word} не является углом; пишите, напр., 0, 30, 60</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_sources.py" />
            <source>angles need a calibration of the accelerometers, this one is of gyros</source>
            <translation>для углов нужна калибровка акселерометров, а это — гироскопов</translation>
        </message>
        <message>
            <location filename="../../core/procedures/accuracy_sources.py" />
            <source>the calibration takes {unit}, the codes are in {unit2}</source>
            <translation>калибровка принимает {unit}, а коды в {unit2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/added.py" />
            <source>of the sensor</source>
            <translation>датчика</translation>
        </message>
        <message>
            <location filename="../../core/procedures/added.py" />
            <source>of this test alone</source>
            <translation>только этого испытания</translation>
        </message>
        <message>
            <location filename="../../core/procedures/added.py" />
            <source>effects are added to plain models alone, not to {join}</source>
            <translation>эффекты добавляются только к простым моделям, а не к {join}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/calibration.py" />
            <source>Q needs three sensors with bias, scale factor and both cross axes each</source>
            <translation>для Q нужны три датчика, каждый с нулевым сигналом, масштабным коэффициентом и обеими перекрёстными</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>Scale factor asymmetry</source>
            <translation>Асимметрия масштабного коэффициента</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>Acceleration-sensitive drift, largest axis</source>
            <translation>Дрейф от ускорения, наибольшая ось</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>{value} (no uncertainty)</source>
            <translation>{value} (без неопределённости)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>no gyro was chosen for the comparison</source>
            <translation>для сравнения не выбрано ни одного гироскопа</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>two gyros have the same name ({join}); tell them apart</source>
            <translation>два гироскопа имеют одинаковое имя ({join}); различите их</translation>
        </message>
        <message>
            <location filename="../../core/procedures/comparison.py" />
            <source>{unit} and {unit2} cannot be compared</source>
            <translation>{unit} и {unit2} невозможно сравнить</translation>
        </message>
        <message>
            <location filename="../../core/procedures/compensation.py" />
            <source>the effects of this calibration are as large as its scale factor at these outputs; they cannot be taken out</source>
            <translation>эффекты этой калибровки при таких выходах столь же велики, как её масштабный коэффициент; исключить их нельзя</translation>
        </message>
        <message>
            <location filename="../../core/procedures/compensation.py" />
            <source>this calibration has effects of temperature: state the temperature</source>
            <translation>эта калибровка содержит температурные эффекты: укажите температуру</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>a limit must be above zero, got {limit}</source>
            <translation>предел должен быть больше нуля, получено {limit}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>nothing was judged</source>
            <translation>ничего не оценено</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>pass: the value and its expanded uncertainty (95 %) lie within the limit; fail: both lie beyond it; otherwise undecided (JCGM 106, guard band w = U)</source>
            <translation>соответствует: значение и его расширенная неопределённость (95 %) лежат в пределе; не соответствует: оба за ним; иначе не решено (JCGM 106, защитная полоса w = U)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/conformity.py" />
            <source>pass: the value lies within the limit, whatever its uncertainty; else fail (ILAC-G8, simple acceptance; the risk of a wrong verdict at the limit is up to 50 %)</source>
            <translation>соответствует: значение лежит в пределе, какова бы ни была его неопределённость; иначе не соответствует (ILAC-G8, простая приёмка; риск неверного решения на пределе до 50 %)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>accelerometers on the dividing head, practicum (1.8), (2.4)</source>
            <translation>акселерометры на делительной головке, практикум (1.8), (2.4)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>local gravity is missing; state it in m/s^2, e.g. 9.8106 for Kyiv</source>
            <translation>местное g отсутствует; укажите его в m/s^2, напр. 9,8106 для Киева</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>rows {rows} give a bias of {bias} {unit}, rows {rows2} one of {bias2}: {difference} {unit2} = {difference2} mg apart. A second-order nonlinearity, a drift or a wrong position would do this; measure more positions to tell which</source>
            <translation>строки {rows} дают нулевой сигнал {bias} {unit}, строки {rows2} — {bias2}: разница {difference} {unit2} = {difference2} mg. Так действовали бы нелинейность второго порядка, дрейф или неверное положение; измерьте больше положений, чтобы узнать</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>{join}: the scale factor is negative, which is legal; the output falls when its axis points up. If every earlier calibration had it positive, the unit was mounted upside down</source>
            <translation>{join}: масштабный коэффициент отрицателен, что допустимо; выход убывает, когда ось смотрит вверх. Если во всех прежних калибровках он был положителен, изделие стояло вверх дном</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>{join} left out: these positions do not determine them; add a rotation about another axis</source>
            <translation>{join} пропущены: эти положения их не определяют; добавьте вращение вокруг другой оси</translation>
        </message>
        <message>
            <location filename="../../core/procedures/dividing_head.py" />
            <source>{name} follows another axis more than its own ({axis}): are the channels permuted, or is the unit mounted about another axis than the plan says?</source>
            <translation>{name} реагирует на другую ось сильнее, чем на свою ({axis}): переставлены каналы или изделие установлено вокруг другой оси, чем говорит план?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/angles.py" />
            <source>segments {which}: the temperature changes by less than {telling} times its uncertainty; the coefficient against temperature (1) is not defined there</source>
            <translation>участки {which}: температура меняется менее чем на {telling} своих неопределённостей; коэффициент по температуре (1) там не определён</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>the knots were moved by hand: the score of this table takes them as given, that of the optimal table also holds what searching them without the held-out turn-on costs</source>
            <translation>узлы передвинуты вручную: оценка этой таблицы берёт их как заданные, а оценка оптимальной содержит и цену их поиска без исключённого включения</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>{limit} knots for {blocks} blocks; state between 2 and {blocks2}</source>
            <translation>{limit} [узел|узла|узлов] на {blocks} [блок|блока|блоков]; укажите от 2 до {blocks2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>{knots} knots; the memory limit allows 2 to {limit}</source>
            <translation>{knots} [узел|узла|узлов]; ограничение памяти допускает от 2 до {limit}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>knots must be two or more times in ascending order</source>
            <translation>узлов должно быть два или больше, по возрастанию времени</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>knots nearer to each other than a block of {block} s mean nothing</source>
            <translation>узлы ближе друг к другу, чем блок {block} s, ничего не значат</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>in the sets at {join} degC there are segments in which the chip's temperature stands still: the source's coefficients against temperature (1) divide by zero there; this table runs over time and needs none</source>
            <translation>в наборах при {join} °C есть участки, где температура кристалла стоит на месте: коэффициенты источника по температуре (1) там делят на ноль; эта таблица идёт по времени и в них не нуждается</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>each temperature has one turn-on: nothing tells drift from what differs between turn-ons, and the number of knots is not tested; make about five</source>
            <translation>у каждой температуры одно включение: ничто не отличает дрейф от различий между включениями, и число узлов не проверено; сделайте около пяти</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>the start is aligned by a mean over {window} s, whose noise of {x} {unit} is a large part of the {by_name} {unit2} that the table leaves; a longer window would help more than more knots</source>
            <translation>начало выровнено по среднему за {window} s, шум которого {x} {unit} составляет большую часть {by_name} {unit2}, которые оставляет таблица; более длинное окно поможет больше, чем больше узлов</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/compensate.py" />
            <source>on turn-ons that it has not seen the table leaves {by_name} {unit}, no correction {by_name2}: the drift does not repeat, do not use it</source>
            <translation>на включениях, которых она не видела, таблица оставляет {by_name} {unit}, без коррекции — {by_name2}: дрейф не повторяется, не используйте её</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>the start window {start} ... {stop} s holds no samples: the records begin at {latest} s</source>
            <translation>начальное окно {start} ... {stop} s не содержит отсчётов: записи начинаются с {latest} s</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>{max} blocks of {block_s} s between {stop} s and {horizon_s} s; at least {fewest_blocks} are needed, with one sample each</source>
            <translation>{max} [блок|блока|блоков] по {block_s} s между {stop} s и {horizon_s} s; нужно не менее {fewest_blocks}, с одним отсчётом в каждом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>the chip's temperature was not measured; the table is entered by the temperature of the chamber, which the unit does not know in use</source>
            <translation>температура кристалла не измерена; вход таблицы — температура камеры, которой изделие в работе не знает</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>the chip's temperature at the start does not rise with that of the chamber: {join} degC; are sets mislabelled?</source>
            <translation>температура кристалла в начале не растёт с температурой камеры: {join} °C; не перепутаны ли наборы?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>all turn-ons were made at {chip} degC: the table holds at this temperature only</source>
            <translation>все включения сделаны при {chip} °C: таблица действительна только при этой температуре</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/curves.py" />
            <source>{label} began at {start} degC, the others of its set at {middle} degC: it had not cooled down and was left out; wait longer between turn-ons (source 003 advises at least 5 minutes)</source>
            <translation>{label} началось с {start} °C, остальные этого набора — с {middle} °C: изделие не остыло, включение пропущено; ждите дольше между включениями (источник 003 советует не менее 5 минут)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/held_out.py" />
            <source>without repeated turn-ons none can be left out</source>
            <translation>без повторных включений ни одно нельзя исключить</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/simulated.py" />
            <source>simulated, {ambient} degC, turn-on {number}</source>
            <translation>симуляция, {ambient} °C, включение {number}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/table.py" />
            <source>{temperature_c} degC is outside the measured {low} ... {high} degC; the drift there is not known</source>
            <translation>{temperature_c} °C вне измеренного {low} ... {high} °C; дрейф там неизвестен</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/table.py" />
            <source>times {min} ... {max} s leave the measured {start} ... {stop} s; the drift there is not known</source>
            <translation>времена {min} ... {max} s выходят за измеренные {start} ... {stop} s; дрейф там неизвестен</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{device}, turn-on {number}</source>
            <translation>{device}, включение {number}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>there is no turn-on</source>
            <translation>нет ни одного включения</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>there are sets at {low} and at {high} degC; give turn-ons of one set the same temperature</source>
            <translation>есть наборы при {low} и при {high} °C; дайте включениям одного набора одинаковую температуру</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: the time since switching on is missing</source>
            <translation>{label}: нет времени от включения</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: rows {place} and {place2} are {steps} s apart, the others {step} s; gaps cannot be averaged over</source>
            <translation>{label}: строки {place} и {place2} отстоят на {steps} s, остальные на {step} s; через пропуски усреднять нельзя</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: sample {bad} is not a number</source>
            <translation>{label}: отсчёт {bad} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: the temperature of the chamber is missing</source>
            <translation>{label}: нет температуры камеры</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label} has {rate} samples per second, {label2} {rate2}; turn-ons of one table need the same</source>
            <translation>{label} имеет {rate} [отсчёт|отсчёта|отсчётов] в секунду, {label2} — {rate2}; включениям одной таблицы нужна одинаковая частота</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: {len} temperatures, {len2} rows</source>
            <translation>{label}: {len} [температура|температуры|температур], {len2} [строка|строки|строк]</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>the turn-ons differ in length: {label} ends at {min} s, {label2} at {max} s; state a horizon of at most {min2} s to use the common part</source>
            <translation>включения разной длины: {label} кончается на {min} s, {label2} — на {max} s; укажите горизонт не более {min2} s, чтобы взять общую часть</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label} ends at {min} s, before the horizon of {horizon_s} s</source>
            <translation>{label} кончается на {min} s, раньше горизонта {horizon_s} s</translation>
        </message>
        <message>
            <location filename="../../core/procedures/drift/turn_on.py" />
            <source>{label}: the temperatures of chamber and chip are both unknown</source>
            <translation>{label}: температуры камеры и кристалла обе неизвестны</translation>
        </message>
        <message>
            <location filename="../../core/procedures/earth.py" />
            <source>this gyro feels the rotation of the Earth, and no latitude was stated: up to {earth_rate_dps} deg/h times the sine of the latitude went into {goes_into}; {remedy}</source>
            <translation>этот гироскоп чувствует вращение Земли, а широта не указана: до {earth_rate_dps} deg/h, умноженных на синус широты, вошли в {goes_into}; {remedy}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/earth.py" />
            <source>this gyro feels the rotation of the Earth, and the azimuth of the head was not stated: up to {level} deg/h went into {goes_into}; state the azimuth of the shaft</source>
            <translation>этот гироскоп чувствует вращение Земли, а азимут головки не указан: до {level} deg/h вошли в {goes_into}; укажите азимут вала</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/faults.py" />
            <source>all angles are multiples of 90 degrees, where the second harmonic is invisible; measure between them, e.g. every 45 or every 5 degrees</source>
            <translation>все углы кратны 90 градусам, где вторая гармоника невидима; измеряйте между ними, напр. через 45 или через 5 градусов</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/faults.py" />
            <source>{len} different angles for {needed} coefficients; measure at least {needed2}, better every 5 degrees</source>
            <translation>{len} разных углов на {needed} коэффициентов; измерьте не менее {needed2}, лучше через 5 градусов</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/faults.py" />
            <source>the output is {extreme}, its {word}, over {span} degrees: it is saturated; choose a wider range of the sensor</source>
            <translation>выход равен {extreme}, своему {word}, на протяжении {span} градусов: он насыщен; выберите более широкий диапазон датчика</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/flip.py" />
            <source>the tumbles are of {axis} in the {axis2}-{cross} plane and of {axis3} in the {axis4}-{cross2} plane; one sensor is needed</source>
            <translation>обороты есть для {axis} в плоскости {axis2}-{cross} и для {axis3} в плоскости {axis4}-{cross2}; нужен один датчик</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/flip.py" />
            <source>the sensor was not turned over between the tumbles: in both the input axis moves in the same sense with the head; turn it by 180 degrees about its input axis</source>
            <translation>датчик не перевёрнут между оборотами: в обоих входная ось движется с головкой в одном направлении; поверните его на 180 градусов вокруг входной оси</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/flip.py" />
            <source>a tumble has no uncertainty; repeat angles</source>
            <translation>у оборота нет неопределённости; повторите углы</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/pairs.py" />
            <source>no axis stood up and down; a test turn needs both positions</source>
            <translation>ни одна ось не стояла вверх и вниз; испытательному обороту нужны оба положения</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/readings.py" />
            <source>{shape} angles for {shape2} readings; one angle a row is needed</source>
            <translation>{shape} [угол|угла|углов] на {shape2} [показание|показания|показаний]; нужен один угол на строку</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>Harmonics of the tumble</source>
            <translation>Гармоники оборота</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>how the output changes over a turn of the head</source>
            <translation>как меняется выход за оборот головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>C0 + C1 sin a + C2 cos a + C3 sin 2a + C4 cos 2a</source>
            <translation>C0 + C1 sin a + C2 cos a + C3 sin 2a + C4 cos 2a</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>the output changes steadily while the head is turned</source>
            <translation>выход равномерно меняется, пока головку вращают</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/series.py" />
            <source>D * (order - middle) / (last - first)</source>
            <translation>D * (порядок - середина) / (последний - первый)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/split.py" />
            <source>the split (18) assumes that the sensor has no quadratic term K2: one of half the size of k_xy would move alpha0 by 13 degrees; turn the sensor over in its fixture and tumble it again to do without the assumption</source>
            <translation>разложение (18) предполагает, что у датчика нет квадратичного члена K2: такой член в половину k_xy сдвинул бы alpha0 на 13 градусов; переверните датчик в оснастке и измерьте оборот снова, чтобы обойтись без предположения</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/split.py" />
            <source>the fit has no uncertainty: repeat angles before splitting (18)</source>
            <translation>у оценки нет неопределённости: повторите углы перед разложением (18)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/split.py" />
            <source>the second harmonic is {ratio} times its uncertainty, {separable} are needed: mounting angle and cross-axis sensitivity cannot be told apart; their sum is {value} +- {expanded} deg</source>
            <translation>вторая гармоника в {ratio} [раз|раза|раз] больше своей неопределённости, нужно {separable}: угол установки и перекрёстную чувствительность не различить; их сумма {value} +- {expanded} deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>{harmonics} harmonics; the series has 2 or 3</source>
            <translation>{harmonics} [гармоника|гармоники|гармоник]; ряд имеет 2 или 3</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the run holds the mounts {join}; a tumble is the turn of one mount, choose its rows</source>
            <translation>серия содержит установки {join}; оборот — это поворот в одной установке, выберите её строки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the angles determine the series badly (condition {condition}); spread them over the whole turn</source>
            <translation>углы плохо определяют ряд (обусловленность {condition}); распределите их по всему обороту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>row {missing}: the head angle is missing</source>
            <translation>строка {missing}: нет угла головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>{channels}: state the case axis along which it looks</source>
            <translation>{channels}: укажите ось корпуса, вдоль которой он смотрит</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the {axis} axis lies along the shaft of the head ({mount}): turning it changes nothing; mount the unit with another axis along the shaft</source>
            <translation>ось {axis} лежит вдоль вала головки ({mount}): её вращение ничего не меняет; установите изделие другой осью вдоль вала</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the output changes by {length} {unit} over a turn, which is not more than noise ({x}): it does not follow the head; is the sensor alive, is this its channel?</source>
            <translation>выход меняется на {length} {unit} за оборот, что не больше шума ({x}): он не следует за головкой; жив ли датчик, его ли это канал?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>the angles leave {gap} degrees of the turn out; an error of the model shows in all coefficients then</source>
            <translation>углы пропускают {gap} [градус|градуса|градусов] оборота; тогда погрешность модели видна во всех коэффициентах</translation>
        </message>
        <message>
            <location filename="../../core/procedures/fourier/tumble.py" />
            <source>after a full turn the output came back changed by {value} +- {student_t} {unit}: it drifts, with temperature or since switching on; fit the drift along, or wait and repeat</source>
            <translation>после полного оборота выход вернулся изменённым на {value} +- {student_t} {unit}: он дрейфует с температурой или от включения; оцените дрейф вместе или подождите и повторите</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>g-sensitivity on the dividing head, practicum (3.7) to (3.9)</source>
            <translation>g-чувствительность на делительной головке, практикум (3.7)–(3.9)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>gravity acts alike in every row: no g-sensitivity can be told from it; measure positions that turn the unit over</source>
            <translation>сила тяжести действует одинаково в каждой строке: g-чувствительности из этого не видно; измерьте положения, переворачивающие изделие</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>the g-sensitivity of {channel}</source>
            <translation>g-чувствительность {channel}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>{channel}: no scale factor is known, so that codes cannot become deg/s; measure it on the rate table</source>
            <translation>{channel}: масштабный коэффициент неизвестен, поэтому коды не станут deg/s; измерьте его на поворотном столе</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>{symbol} of {channel}</source>
            <translation>{symbol} канала {channel}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/g_sensitivity.py" />
            <source>state the latitude</source>
            <translation>укажите широту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>Earth rate on a turning axis, and drift</source>
            <translation>Вращение Земли на поворачиваемой оси и дрейф</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the axis feels the Earth by its azimuth, and drifts</source>
            <translation>ось чувствует Землю по своему азимуту и дрейфует</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>A cos(delta) - B sin(delta) + d</source>
            <translation>A cos(delta) - B sin(delta) + d</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>Drift ramp</source>
            <translation>Линейное изменение дрейфа</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the drift changes steadily, e.g. while the unit warms up</source>
            <translation>дрейф равномерно меняется, напр. пока изделие прогревается</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>r * (t - middle)</source>
            <translation>r * (t - середина)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the tilt brings in the vertical part of the Earth's rate: state the latitude</source>
            <translation>наклон вносит вертикальную составляющую вращения Земли: укажите широту</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>a latitude of {latitude_deg} deg does not exist; -90 to 90, south negative</source>
            <translation>широты {latitude_deg} deg не существует; от -90 до 90, южная отрицательна</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>at {latitude_deg} deg of latitude the Earth's rate has no level part to speak of ({dph_per_dps} deg/h): at a pole a gyro finds no heading</source>
            <translation>на широте {latitude_deg} deg горизонтальной составляющей вращения Земли почти нет ({dph_per_dps} deg/h): на полюсе гироскоп не находит курса</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the output is in {unit}, which is no rate; state the scale factor in {unit2}/(deg/s)</source>
            <translation>выход в {unit}, что не является угловой скоростью; укажите масштабный коэффициент в {unit2}/(deg/s)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>as many headings as unknowns leave no uncertainty; add a heading, or standard errors</source>
            <translation>курсов столько, сколько неизвестных, поэтому нет неопределённости; добавьте курс или стандартные погрешности</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>; the Earth's is {earth} there</source>
            <translation>; земная там {earth}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the rate changes by {length} deg/h with the heading, u = {x} deg/h{there}: north cannot be told from noise; average longer, or use a quieter gyro</source>
            <translation>скорость меняется на {length} deg/h с курсом, u = {x} deg/h{there}: север не отличить от шума; усредняйте дольше или возьмите более тихий гироскоп</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>{leak} arcmin</source>
            <translation>{leak} угл. мин</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>tan(latitude) arcmin</source>
            <translation>tan(широты) угл. мин</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>these headings do not tell the Earth's rate from drift; turn the base in steps of 90 degrees (at least three different headings, not all on one line)</source>
            <translation>эти курсы не отличают вращение Земли от дрейфа; поворачивайте основание шагами по 90 градусов (не менее трёх разных курсов, не на одной прямой)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>no latitude was stated: the {value} deg/h that were found could not be compared with the Earth's rate</source>
            <translation>широта не указана: найденные {value} deg/h не сравнить с вращением Земли</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the tilt was not measured: each arcmin by which the base leans east or west moves the heading by {much}</source>
            <translation>наклон не измерен: каждая угловая минута наклона основания на восток или запад сдвигает курс на {much}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/gyrocompass.py" />
            <source>the level part of the Earth's rate came out as {value} +- {expanded} deg/h, at {latitude_deg} deg it is {expected_dph}: check scale factor and latitude; the heading does not depend on them</source>
            <translation>горизонтальная составляющая вращения Земли вышла {value} +- {expanded} deg/h, на широте {latitude_deg} deg она {expected_dph}: проверьте масштабный коэффициент и широту; курс от них не зависит</translation>
        </message>
        <message>
            <location filename="../../core/procedures/measuring.py" />
            <source>the head moved during accumulation ({names} changed); wait and accumulate again</source>
            <translation>головка двигалась во время накопления (изменились {names}); подождите и накопите снова</translation>
        </message>
        <message>
            <location filename="../../core/procedures/north_seeking.py" />
            <source>these headings do not tell the Earth's rate from drift; use steps of 90 deg</source>
            <translation>эти курсы не отличают вращение Земли от дрейфа; поворачивайте шагами по 90 deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/north_seeking.py" />
            <source>at {latitude_deg} deg of latitude a gyro finds no heading</source>
            <translation>на широте {latitude_deg} deg гироскоп не находит курса</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a tumble is the turn of one mount</source>
            <translation>оборот — это поворот в одной установке</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>the {axis} axis lies along the shaft</source>
            <translation>ось {axis} лежит вдоль вала</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a gyrocompass needs the latitude, and a place that is no pole</source>
            <translation>гирокомпасу нужны широта и место, которое не является полюсом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Positions on the dividing head</source>
            <translation>Положения на делительной головке</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>bias, scale factor and cross-axis sensitivity of one to nine accelerometers; of a triad the matrix Q, non-orthogonality and mounting</source>
            <translation>нулевой сигнал, масштабный коэффициент и перекрёстная чувствительность от одного до девяти акселерометров; для триады — матрица Q, неортогональность и установка</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; four positions about one axis for a part, six or eight for all of them</source>
            <translation>g; четыре положения вокруг одной оси для части, шесть или восемь для всех</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Fourier tumble</source>
            <translation>Оборот по Фурье</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>bias, sensitivity and misalignment of one accelerometer in the plane of rotation, and its second and third harmonic (nonlinearity)</source>
            <translation>нулевой сигнал, чувствительность и несоосность одного акселерометра в плоскости вращения, его вторая и третья гармоники (нелинейность)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; at least 5 different angles that are not all multiples of 90 degrees, better 80; a second run with the sensor turned over to tell the fixture from the sensor</source>
            <translation>g; не менее 5 разных углов, не все кратны 90 градусам, лучше 80; вторая серия с перевёрнутым датчиком, чтобы отличить оснастку от датчика</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Positions over temperature</source>
            <translation>Положения по температуре</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>bias and scale factor against temperature, told apart, and their hysteresis</source>
            <translation>нулевой сигнал и масштабный коэффициент по температуре, различённые, и их гистерезис</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; each axis up and down at two temperatures or more, S + 2 for order S; both ways through the temperatures to see hysteresis</source>
            <translation>g; каждая ось вверх и вниз при двух температурах или более, S + 2 для порядка S; в обе стороны через температуры, чтобы увидеть гистерезис</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>Rates on the table</source>
            <translation>Скорости на столе</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>scale factor and zero of gyros, nonlinearity, asymmetry; cross axes by re-mounting</source>
            <translation>масштабный коэффициент и нулевой сигнал гироскопов, нелинейность, асимметрия; перекрёстные оси — переустановкой</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>three rates or more, of both signs</source>
            <translation>три скорости или более, обоих знаков</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g-sensitivity on the dividing head</source>
            <translation>g-чувствительность на делительной головке</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>how gravity shifts the zero of gyros</source>
            <translation>как сила тяжести смещает нулевой сигнал гироскопов</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>g; four positions about one axis, eight for all three; the latitude for gyros that feel the Earth</source>
            <translation>g; четыре положения вокруг одной оси, восемь для всех трёх; широта для гироскопов, чувствующих Землю</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a table of the drift against time and chip temperature, for a microcontroller</source>
            <translation>таблица дрейфа по времени и температуре кристалла, для микроконтроллера</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>about five turn-ons at each of several temperatures, at most 10 to 20 degC apart, cooled down between them</source>
            <translation>около пяти включений при каждой из нескольких температур, не дальше 10–20 °C друг от друга, с охлаждением между ними</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>heading of the base and systematic drift of the gyro</source>
            <translation>курс основания и систематический дрейф гироскопа</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/catalogue.py" />
            <source>a gyro with far less drift than the level part of the Earth's rate; three headings or more, best in steps of 90 degrees; the tilt by an accelerometer; no pole</source>
            <translation>гироскоп с дрейфом намного меньше горизонтальной составляющей вращения Земли; три курса или более, лучше всего через 90 градусов; наклон по акселерометру; не полюс</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/design.py" />
            <source>state the white noise of the sensor (N of its Allan analysis)</source>
            <translation>укажите белый шум датчика (N из его анализа Аллана)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>there is no method {method}; there are: {join}</source>
            <translation>метода {method} нет; есть: {join}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>{title}: nothing can be predicted without a record; {needs}</source>
            <translation>{title}: без записи ничего предсказать нельзя; {needs}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>{title} is for a {kind}, the sensor is a {kind2}</source>
            <translation>{title} — для {kind}, а датчик — {kind2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>the plan {id} is for another method than {title}</source>
            <translation>план {id} — для другого метода, чем {title}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>the plan {id} has no step {names}</source>
            <translation>в плане {id} нет шага {names}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/propose.py" />
            <source>no position is left</source>
            <translation>не осталось ни одного положения</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a response to the square of the input (K2)</source>
            <translation>отклик на квадрат входа (K2)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>add positions between the upright ones, e.g. 45 degrees, or rates of half the size</source>
            <translation>добавьте положения между прямыми, напр. 45 градусов, или скорости вдвое меньше</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a response to the cube of the input (K3)</source>
            <translation>отклик на куб входа (K3)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>add positions at 30 or 45 degrees, or rates of other sizes</source>
            <translation>добавьте положения на 30 или 45 градусах или скорости других величин</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a response to the product of two inputs (k_xy)</source>
            <translation>отклик на произведение двух входов (k_xy)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>add positions at which both axes feel gravity, e.g. 45 degrees</source>
            <translation>добавьте положения, где обе оси чувствуют силу тяжести, напр. 45 градусов</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>{replace}: no position of this plan changes the input that shows it</source>
            <translation>{replace}: ни одно положение этого плана не меняет входа, который это показывает</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>as many positions as unknowns: any reading fits, so a wrong one would not be noticed; add a position, or measure one again</source>
            <translation>положений столько, сколько неизвестных: подходит любое показание, поэтому неверного не заметить; добавьте положение или измерьте одно снова</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>one temperature: how bias and scale factor change with it stays unknown</source>
            <translation>одна температура: как с ней меняются нулевой сигнал и масштабный коэффициент, остаётся неизвестным</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>no position comes twice: a drift while measuring passes for a property of the sensor; go back to the first position at the end</source>
            <translation>ни одно положение не повторяется: дрейф во время измерения выдаёт себя за свойство датчика; в конце вернитесь к первому положению</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>a base that leans east or west moves the heading by tan(latitude) of its tilt; measure the tilt by an accelerometer</source>
            <translation>основание, наклонённое на восток или запад, сдвигает курс на tan(широты) его наклона; измерьте наклон акселерометром</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>only {dof} reading(s) more than unknowns: where the scatter must be found from the residuals, intervals are {student_t} u wide instead of 2 u</source>
            <translation>показаний лишь на {dof} больше, чем неизвестных: там, где разброс приходится искать из остатков, интервалы имеют ширину {student_t} u вместо 2 u</translation>
        </message>
        <message>
            <location filename="../../core/procedures/prediction/unseen.py" />
            <source>{words} hides in the other parameters; {remedy}</source>
            <translation>{words} прячется в других параметрах; {remedy}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>gyros on rate table and dividing head, practicum (3.3)</source>
            <translation>гироскопы на поворотном столе и делительной головке, практикум (3.3)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>the table run is in {unit}, the head run in {unit2}</source>
            <translation>серия стола в {unit}, серия головки в {unit2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>no output stands in both runs: {join} and {join2}</source>
            <translation>ни одного выхода нет в обеих сериях: {join} и {join2}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_and_head.py" />
            <source>{name} did not answer to the rate table</source>
            <translation>{name} не ответил на вращение стола</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the set rate is wrong, or something disturbed the accumulation</source>
            <translation>заданная скорость неверна или что-то нарушило накопление</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the table stood still</source>
            <translation>стол стоял</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the table was turned the wrong way, or the sign of the rate is wrong</source>
            <translation>стол вращали в другую сторону или знак скорости неверен</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>as if the table had turned for {ratio} % of the accumulation: it stopped or slowed down</source>
            <translation>как если бы стол вращался лишь {ratio} % накопления: он остановился или замедлился</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>in {join}</source>
            <translation>в {join}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>the set rate seems to be in {unit}</source>
            <translation>заданная скорость, похоже, в {unit}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>row {rows}, {place} deg/s: the mean is {times} times less certain than in the other rows; the table changed its rate during the accumulation</source>
            <translation>строка {rows}, {place} deg/s: среднее в {times} [раз|раза|раз] менее точно, чем в других строках; стол изменил скорость во время накопления</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>row {rows}, {place} deg/s: the output{who} stands for {implied} deg/s; {story}. Repeat this rate, or leave the row out</source>
            <translation>строка {rows}, {place} deg/s: выход{who} соответствует {implied} deg/s; {story}. Повторите эту скорость или исключите строку</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_faults.py" />
            <source>{channels}: at {rates} deg/s the output ({outputs}) no longer follows the rate; the sensor or its converter is at its limit. These rows are left out of the line</source>
            <translation>{channels}: при {rates} deg/s выход ({outputs}) больше не следует за скоростью; датчик или его преобразователь на пределе. Эти строки не входят в прямую</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>the rows are from {min} to {max} degC, and one line went through all of them; fit each temperature on its own</source>
            <translation>строки от {min} до {max} °C, и через все проведена одна прямая; оцените каждую температуру отдельно</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>Unequal scale factors of the two senses ({value} ppm) would look much the same; more rates near zero tell the two apart.</source>
            <translation>Неравные масштабные коэффициенты двух направлений ({value} ppm) выглядели бы почти так же; больше скоростей около нуля их различат.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor {value} {unit} has the opposite sign of the expected {expected}: the table was turned the wrong way, or the unit lay upside down</source>
            <translation>{channel}: масштабный коэффициент {value} {unit} имеет знак, противоположный ожидаемому {expected}: стол вращали в другую сторону или изделие лежало вверх дном</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor {value} {unit} is {found} % from the expected {expected}: another unit, range or channel?</source>
            <translation>{channel}: масштабный коэффициент {value} {unit} отличается на {found} % от ожидаемого {expected}: другое изделие, диапазон или канал?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: two rates always lie on a line, so nothing can contradict it; measure three or more</source>
            <translation>{channel}: две скорости всегда лежат на прямой, поэтому ничто не может ей противоречить; измерьте три или более</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: no answer to the rate ({value} +/- {expanded} {unit}); another axis, or the table did not turn</source>
            <translation>{channel}: нет ответа на скорость ({value} +/- {expanded} {unit}); другая ось, или стол не вращался</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor is negative ({value} {unit}), which is legal; the output falls when the unit turns counter-clockwise seen from above</source>
            <translation>{channel}: масштабный коэффициент отрицателен ({value} {unit}), что допустимо; выход убывает, когда изделие вращается против часовой стрелки, если смотреть сверху</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>the zero of {channel}</source>
            <translation>нулевой сигнал {channel}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>the errors of {len} sensors go together ({std} deg/s): the table is at fault, not the sensors. State the uncertainty of its rate, so that it weighs</source>
            <translation>погрешности {len} [датчика|датчиков|датчиков] идут вместе ({std} deg/s): виноват стол, а не датчики. Укажите неопределённость его скорости, чтобы она учитывалась</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the straight line is rejected (p = {p_value}); a {shape} of {value} {unit} fits significantly better. It bends the characteristic by {abs} ppm of {full_scale} deg/s.{also}</source>
            <translation>{channel}: прямая отвергнута (p = {p_value}); {shape} {value} {unit} подходит значимо лучше. Она изгибает характеристику на {abs} ppm от {full_scale} deg/s.{also}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_notes.py" />
            <source>{channel}: the scale factor is {found} times the expected one, which is the ratio of deg/s and {unit}: the rates or the outputs are in another unit</source>
            <translation>{channel}: масштабный коэффициент в {found} [раз|раза|раз] больше ожидаемого, а это отношение deg/s и {unit}: скорости или выходы в других единицах</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_recognition.py" />
            <source>this is not {labels}: the outputs stand for {shown} deg/s; {story}</source>
            <translation>это не {labels}: выходы соответствуют {shown} deg/s; {story}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>gyros on the rate table, practicum (3.4) to (3.6)</source>
            <translation>гироскопы на поворотном столе, практикум (3.4)–(3.6)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>{channel}: the same output in every row; the sensor is dead or not connected</source>
            <translation>{channel}: одинаковый выход в каждой строке; датчик не работает или не подключён</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>the outputs are the same in every row; nothing was measured</source>
            <translation>выходы одинаковы в каждой строке; ничего не измерено</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>row {row}: the output {channels} is not a number</source>
            <translation>строка {row}: выход {channels} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>every row has the same rate ({x} deg/s): neither the scale factor nor the zero can be told from it; measure at two rates or more, better eleven</source>
            <translation>в каждой строке одинаковая скорость ({x} deg/s): ни масштабного коэффициента, ни нулевого сигнала из этого не видно; измерьте две скорости или более, лучше одиннадцать</translation>
        </message>
        <message>
            <location filename="../../core/procedures/rate_table.py" />
            <source>{join}: no row turns about {axis}, their own axis</source>
            <translation>{join}: ни одна строка не вращается вокруг {axis}, их собственной оси</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise.py" />
            <source>this looks like {names}, not {labels}</source>
            <translation>это похоже на {names}, а не на {labels}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise.py" />
            <source>this is not {labels} and fits no other position of the plan; the nearest is {labels2}. Check how the unit is mounted and the head angle</source>
            <translation>это не {labels} и не подходит ни к одному другому положению плана; ближайшее — {labels2}. Проверьте, как установлено изделие, и угол головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise.py" />
            <source>{name} axis reversed: the signs fit {labels} with {name2} pointing the other way; turn the unit over, or change the polarity in its profile</source>
            <translation>ось {name} наоборот: знаки соответствуют {labels} с {name2} в противоположную сторону; переверните изделие или измените полярность в его профиле</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise_angles.py" />
            <source>the unit tells a {kind} of {outputs} deg</source>
            <translation>изделие показывает {kind} {outputs} deg</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise_angles.py" />
            <source>{told}: this looks like {names}, not {labels}</source>
            <translation>{told}: это похоже на {names}, а не на {labels}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/recognise_angles.py" />
            <source>{told}, which is not {labels} and no other position of the plan; check how the unit is mounted and the head angle</source>
            <translation>{told}, что не является {labels} и никаким другим положением плана; проверьте, как установлено изделие, и угол головки</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>the file does not hold the set angles; its rows were taken as {kind} {first}, ... of the practicum's list Angles</source>
            <translation>файл не содержит заданных углов; его строки взяты как {kind} {first}, ... из списка Angles практикума</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>the run does not hold the set angles; give them, e.g. 0,30,60</source>
            <translation>серия не содержит заданных углов; укажите их, напр. 0,30,60</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>{len} set angles were given for {len2} rows</source>
            <translation>дано {len} заданных углов на {len2} [строку|строки|строк]</translation>
        </message>
        <message>
            <location filename="../../core/procedures/set_angles.py" />
            <source>pitch is set with X along the shaft, roll with Y; this run has neither</source>
            <translation>тангаж задают с X вдоль вала, крен — с Y; в этой серии нет ни того, ни другого</translation>
        </message>
        <message>
            <location filename="../../core/procedures/six_position.py" />
            <source>the nine-parameter form of source 002 leaves {residual_mg} mg on {axes}, the twelve parameters {left_mg} mg: the sensor block is turned by {angle} deg in the platform, for which that form has no parameter</source>
            <translation>девятипараметрическая форма источника 002 оставляет {residual_mg} mg на {axes}, двенадцать параметров — {left_mg} mg: блок датчиков повёрнут на {angle} deg в платформе, для чего у этой формы нет параметра</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>sensors over temperature, source 002 (4) to (7)</source>
            <translation>датчики по температуре, источник 002 (4)–(7)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>all rows were measured at {temperature_c} degC; a dependence on temperature needs two temperatures, to test one three</source>
            <translation>все строки измерены при {temperature_c} °C; для зависимости от температуры нужны две температуры, для её проверки — три</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>the {axis} axis felt the same in all rows, where a change of the scale factor with temperature reads as one of the bias; measure it up and down at each temperature</source>
            <translation>ось {axis} чувствовала одно и то же во всех строках, где изменение масштабного коэффициента с температурой читается как изменение нулевого сигнала; измерьте её вверх и вниз при каждой температуре</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>{min} ... {max} degC leaves the measured {low_c} ... {high_c} degC; polynomials mean nothing outside</source>
            <translation>{min} ... {max} °C выходит за измеренное {low_c} ... {high_c} °C; полиномы там ничего не значат</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>order {order} needs {order2} temperatures ({order3} to test it), there are {levels}</source>
            <translation>порядку {order} нужно {order2} [температура|температуры|температур] ({order3} для проверки), есть {levels}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>two temperatures give a straight line that nothing can contradict; measure a third between them</source>
            <translation>две температуры дают прямую, которой ничто не может противоречить; измерьте третью между ними</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>at {join} degC an axis did not stand both up and down; there the scale factor is taken from the other temperatures</source>
            <translation>при {join} °C какая-то ось не стояла и вверх, и вниз; там масштабный коэффициент взят из других температур</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/cycle.py" />
            <source>{channel}: at {temperature_c} degC the bias reached by heating is {value} {unit} from that reached by cooling; no function of the temperature can compensate that</source>
            <translation>{channel}: при {temperature_c} °C нулевой сигнал, достигнутый нагревом, отличается на {value} {unit} от достигнутого охлаждением; никакая функция температуры этого не скомпенсирует</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>the runs are of {join}; is it one unit?</source>
            <translation>серии от {join}; одно ли это изделие?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>the runs state different g: {join} m/s^2</source>
            <translation>серии указывают разные g: {join} m/s^2</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>there is no run</source>
            <translation>нет ни одной серии</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>{words}; that of the first is taken</source>
            <translation>{words}; взято из первой</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/joined.py" />
            <source>{device} and {device2} differ in {what}: {getattr} and {getattr2}; one set needs one unit, measured alike</source>
            <translation>{device} и {device2} различаются: {what}: {getattr} и {getattr2}; одному набору нужно одно изделие, измеренное одинаково</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/over_temperature.py" />
            <source>Temperature sensitivity</source>
            <translation>Температурная чувствительность</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/over_temperature.py" />
            <source>parameters change with the temperature</source>
            <translation>параметры меняются с температурой</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/plateaus.py" />
            <source>row {missing}: the temperature is missing; a run over temperature needs it in every row</source>
            <translation>строка {missing}: нет температуры; серии по температуре она нужна в каждой строке</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>order {order}; the record allows 0 to {highest}</source>
            <translation>порядок {order}; запись допускает от 0 до {highest}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>{len} rows; a record over temperature needs at least {fewest_rows}</source>
            <translation>{len} [строка|строки|строк]; записи по температуре нужно не менее {fewest_rows}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>the temperature stayed between {min} and {max} degC; a dependence on it needs a span of {span_c} degC or more</source>
            <translation>температура оставалась между {min} и {max} °C; для зависимости от неё нужен размах {span_c} °C или более</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>{temperature_c} degC is outside the measured {low_c} ... {high_c} degC; polynomials mean nothing there</source>
            <translation>{temperature_c} °C вне измеренного {low_c} ... {high_c} °C; полиномы там ничего не значат</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>row {bad}: the {what} is not a number</source>
            <translation>строка {bad}: {what} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>the unit stood in one orientation: an axis that feels a part of g shows the change of its scale factor as one of its bias; measure positions at each temperature to tell them apart</source>
            <translation>изделие стояло в одном положении: ось, чувствующая часть g, показывает изменение масштабного коэффициента как изменение нулевого сигнала; измерьте положения при каждой температуре, чтобы их различить</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/record.py" />
            <source>{channel}: at {hysteresis_at_c} degC the output while heating is {value} {unit} from that while cooling: lag, hysteresis or a drift in time, which no polynomial of the temperature can compensate</source>
            <translation>{channel}: при {hysteresis_at_c} °C выход при нагреве отличается на {value} {unit} от выхода при охлаждении: запаздывание, гистерезис или дрейф во времени, чего полином температуры не скомпенсирует</translation>
        </message>
        <message>
            <location filename="../../core/procedures/thermal/simulated.py" />
            <source>simulated triad</source>
            <translation>симулированная триада</translation>
        </message>
        <message>
            <location filename="../../core/procedures/triad.py" />
            <source>axes {join} are no triad; each of x, y, z is needed once</source>
            <translation>оси {join} не являются триадой; каждая из x, y, z нужна один раз</translation>
        </message>
        <message>
            <location filename="../../core/procedures/triad.py" />
            <source>the matrix K is singular: two sensors feel the same axis</source>
            <translation>матрица K вырождена: два датчика чувствуют одну и ту же ось</translation>
        </message>
        <message>
            <location filename="../../core/procedures/triad.py" />
            <source>the {axis} sensor has no parameter {error}</source>
            <translation>у датчика {axis} нет параметра {error}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>the table file is of {table}, the head file of {head}: scale factor and zero of two units do not belong together.</source>
            <translation>файл стола от {table}, файл головки от {head}: масштабный коэффициент и нулевой сигнал двух изделий не сочетаются.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>; another day, another temperature, or another unit?</source>
            <translation>; другой день, другая температура или другое изделие?</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>{channel}: the zero is {value} {unit} on the table, while the head lets expect {predicted}; (3.10) puts {value2} deg/s into every rate{why}</source>
            <translation>{channel}: нулевой сигнал на столе {value} {unit}, а по головке ожидается {predicted}; (3.10) добавляет {value2} deg/s к каждой скорости{why}</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>the table run was at {mean} degC, the head run at {mean2} degC: the zero moves with temperature.</source>
            <translation>серия стола была при {mean} °C, серия головки — при {mean2} °C: нулевой сигнал меняется с температурой.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>{name}: the first {x} temperatures of the two files are the same digit for digit; one of them was copied, so they cannot tell whether the runs were alike.</source>
            <translation>{name}: первые {x} [температуры|температур|температур] двух файлов совпадают цифра в цифру; одна из них скопирована, поэтому они не говорят, были ли серии одинаковы.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/two_files.py" />
            <source>{name}: the head run was {apart} codes from the table run: the zero moves with temperature.</source>
            <translation>{name}: серия головки отличается на {apart} [код|кода|кодов] от серии стола: нулевой сигнал меняется с температурой.</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>position {number} ({head_deg} deg)</source>
            <translation>положение {number} ({head_deg} deg)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>rate {number} ({rate_dps} deg/s)</source>
            <translation>скорость {number} ({rate_dps} deg/s)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>heading {number} ({head_deg} deg)</source>
            <translation>курс {number} ({head_deg} deg)</translation>
        </message>
        <message>
            <location filename="../../core/procedures/walk.py" />
            <source>the device sends no sensor output that the plan {title} could measure</source>
            <translation>устройство не передаёт выхода датчика, который мог бы измерить план {title}</translation>
        </message>
        <message>
            <location filename="../../core/records/atomic.py" />
            <source>free some disk space or choose another folder, then save again</source>
            <translation>освободите место на диске или выберите другую папку, затем сохраните снова</translation>
        </message>
        <message>
            <location filename="../../core/records/atomic.py" />
            <source>{path}: cannot be written ({strerror}); {saved}; {remedy}</source>
            <translation>{path}: невозможно записать ({strerror}); {saved}; {remedy}</translation>
        </message>
        <message>
            <location filename="../../core/records/atomic.py" />
            <source>what stood there before is untouched</source>
            <translation>то, что там было раньше, не тронуто</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>U in {unit}, {symbol} in {unit2}</source>
            <translation>U в {unit}, {symbol} в {unit2}</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>+ e, the added effects</source>
            <translation>+ e, добавленные эффекты</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>accelerometer or gyro</source>
            <translation>акселерометр или гироскоп</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>at least one channel</source>
            <translation>хотя бы один канал</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>x, y, z or empty</source>
            <translation>x, y, z или пусто</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>an identifier of the catalogue</source>
            <translation>идентификатор каталога</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>names of parameters of the fit</source>
            <translation>имена параметров оценки</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>at least one parameter</source>
            <translation>хотя бы один параметр</translation>
        </message>
        <message>
            <location filename="../../core/records/calibration_json.py" />
            <source>{where}: a parameter has no value</source>
            <translation>{where}: у параметра нет значения</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>The last row is incomplete, as after a power cut, and is left out.</source>
            <translation>Последняя строка неполна, как после отключения питания; она пропущена.</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>{per_line} values; the head names {len} channels</source>
            <translation>{per_line} [значение|значения|значений]; заголовок называет {len} [канал|канала|каналов]</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>holds no rows</source>
            <translation>не содержит строк</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>no file of CVGCom: its head has no line {names_key}</source>
            <translation>не файл CVGCom: в заголовке нет строки {names_key}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>{names_key} has {len} names, {count_key} is {count}</source>
            <translation>{names_key} имеет {len} [имя|имени|имён], {count_key} равно {count}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>{time_key} is {sampling}; must be above zero</source>
            <translation>{time_key} равно {sampling}; должно быть больше нуля</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom.py" />
            <source>the head has no line {key}</source>
            <translation>в заголовке нет строки {key}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom_writer.py" />
            <source>{path}: cannot be created: {strerror}</source>
            <translation>{path}: невозможно создать: {strerror}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom_writer.py" />
            <source>{path}: cannot be written: {strerror}</source>
            <translation>{path}: невозможно записать: {strerror}</translation>
        </message>
        <message>
            <location filename="../../core/records/cvgcom_writer.py" />
            <source>{path}: not safe on disk: {strerror}</source>
            <translation>{path}: не сохранено надёжно на диске: {strerror}</translation>
        </message>
        <message>
            <location filename="../../core/records/decimals.py" />
            <source>{shown} is no number</source>
            <translation>{shown} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>correction_at_{value}_degC ({unit})</source>
            <translation>correction_at_{value}_degC ({unit})</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>C header with int16 table</source>
            <translation>Заголовок C с таблицей int16</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>JSON with scores and provenance</source>
            <translation>JSON с оценками и происхождением</translation>
        </message>
        <message>
            <location filename="../../core/records/drift_exports.py" />
            <source>CSV of the table</source>
            <translation>CSV таблицы</translation>
        </message>
        <message>
            <location filename="../../core/records/export_csv.py" />
            <source>added to {name}: {name2}, {equation}; {reach}</source>
            <translation>добавлено к {name}: {name2}, {equation}; {reach}</translation>
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
            <translation>JSON с ковариацией и происхождением</translation>
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
            <translation>CSV с десятичной запятой, для Excel</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} holds the test {test}; it tells nothing that is compared</source>
            <translation>{name} содержит испытание {test}; в нём нечего сравнивать</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} is a calibration of accelerometers; gyros are compared here</source>
            <translation>{name} — калибровка акселерометров; здесь сравнивают гироскопы</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} holds accelerometers; gyros are compared here</source>
            <translation>{name} содержит акселерометры; здесь сравнивают гироскопы</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name} holds no noise of a gyro in deg/s; state its scale factor</source>
            <translation>{name} не содержит шума гироскопа в deg/s; укажите его масштабный коэффициент</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name}: the {replace} of {source} is in {unit}; its scale factor is missing: add a run on the rate table</source>
            <translation>{name}: {replace} из {source} в {unit}; его масштабного коэффициента нет: добавьте серию на поворотном столе</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>is no table of noise coefficients: {error}</source>
            <translation>не таблица коэффициентов шума: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{name}: two files differ in the {replace} by {apart} standard uncertainties; that of {source} is shown</source>
            <translation>{name}: два файла различаются в {replace} на {apart} стандартных неопределённостей; показано значение из {source}</translation>
        </message>
        <message>
            <location filename="../../core/records/gyro_facts.py" />
            <source>{device} {channel}: the {replace} was not detected, it is below {upper} {noise} (95 %)</source>
            <translation>{device} {channel}: {replace} не обнаружено, оно меньше {upper} {noise} (95 %)</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>is no {schema} document (schema = {found})</source>
            <translation>не документ {schema} (schema = {found})</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>was written by a newer CalRig ({schema} version {number}; this program reads up to version {version}): update CalRig</source>
            <translation>записано более новой версией CalRig ({schema}, версия {number}; эта программа читает до версии {version}): обновите CalRig</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>is no JSON object</source>
            <translation>не объект JSON</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{place} must be {wanted}, found {shown}</source>
            <translation>{place}: нужно {wanted}, найдено {shown}</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>damaged JSON: {msg}</source>
            <translation>повреждённый JSON: {msg}</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>damaged JSON: {error}</source>
            <translation>повреждённый JSON: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a moment such as 2024-05-13T14:05:00+03:00</source>
            <translation>момент вида 2024-05-13T14:05:00+03:00</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>true or false</source>
            <translation>true или false</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a whole number</source>
            <translation>целое число</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{size} numbers</source>
            <translation>{size} [число|числа|чисел]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{len} items</source>
            <translation>{len} [элемент|элемента|элементов]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{len} rows</source>
            <translation>{len} [строка|строки|строк]</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>an object</source>
            <translation>объект</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>a list</source>
            <translation>список</translation>
        </message>
        <message>
            <location filename="../../core/records/json_fields.py" />
            <source>{place} is missing</source>
            <translation>{place} отсутствует</translation>
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
            <translation>текст, число либо true или false</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>set temperature</source>
            <translation>заданная температура</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>head angle</source>
            <translation>угол головки</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>position number</source>
            <translation>номер положения</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>rate number</source>
            <translation>номер скорости</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>row number</source>
            <translation>номер строки</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>holds no rows of {device}, only of {join}</source>
            <translation>не содержит строк {device}, только {join}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>{title} holds no {sensor}</source>
            <translation>{title} не содержит {sensor}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>mounts are given, but the numbers of {title} already tell them</source>
            <translation>установки заданы, но номера {title} их уже определяют</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>every {sensor} output is zero: nothing was measured</source>
            <translation>каждый выход {sensor} равен нулю: ничего не измерено</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>{path}: positions 5 to 12 of Pointer are not described in the practicum; they are taken as {join}</source>
            <translation>{path}: положения Pointer с 5 по 12 не описаны в практикуме; они взяты как {join}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/file.py" />
            <source>holds rows of {len} devices ({join}): say which one</source>
            <translation>содержит строки {len} [устройства|устройств|устройств] ({join}): скажите, какого</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>OpticalDividingHead of ClbAcc (Table 1.2)</source>
            <translation>OpticalDividingHead программы ClbAcc (таблица 1.2)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>OpticalDividingHead of Pointer (Table 2.2)</source>
            <translation>OpticalDividingHead программы Pointer (таблица 2.2)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>OpticalDividingHead of ClbDUS (Table 3.3)</source>
            <translation>OpticalDividingHead программы ClbDUS (таблица 3.3)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>RotationTable of ClbDUS (Table 3.2)</source>
            <translation>RotationTable программы ClbDUS (таблица 3.2)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>Accuracy of Pointer (Table 2.4)</source>
            <translation>Accuracy программы Pointer (таблица 2.4)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>Accuracy of Pointer, the 15 columns that Table 2.4 prints</source>
            <translation>Accuracy программы Pointer, 15 столбцов, напечатанных в таблице 2.4</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>{value} stands where the {name} must be a whole number</source>
            <translation>стоит {value} там, где {name} должен быть целым числом</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>{value} stands where the {name} must be {span}</source>
            <translation>стоит {value} там, где {name} должен быть {span}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 3</source>
            <translation>столбец 3</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>{low} to {high}</source>
            <translation>от {low} до {high}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>position number {position} does not belong to head angle {angle} deg (column 3), which is position {position_of}</source>
            <translation>номер положения {position} не принадлежит углу головки {angle} deg (столбец 3), который является положением {position_of}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 5</source>
            <translation>столбец 5</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 6</source>
            <translation>столбец 6</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/layout.py" />
            <source>column 4</source>
            <translation>столбец 4</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>give the mounts, one a pass, e.g. X_from,Y_from, or one for all rows</source>
            <translation>укажите установки, по одной на проход, напр. X_from,Y_from, или одну для всех строк</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>at each temperature</source>
            <translation>при каждой температуре</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>one pass of angles{place} is taken as X_from</source>
            <translation>один проход углов{place} взят как X_from</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>the angles start over{place}, so that the first pass is taken as X_from and the second as Y_from</source>
            <translation>углы начинаются снова{place}, поэтому первый проход взят как X_from, а второй — как Y_from</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>{path}: the layout holds no mount; {text}</source>
            <translation>{path}: этот формат не содержит установки; {text}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>{len} mounts are given, but {count}; {give}</source>
            <translation>дано {len} [установка|установки|установок], но {count}; {give}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>in {visits} stays at a temperature</source>
            <translation>за {visits} [остановку|остановки|остановок] на температуре</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>{count}; this does not tell how the unit was mounted: {give}</source>
            <translation>{count}; это не говорит, как было установлено изделие: {give}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/mounts.py" />
            <source>head angle {angles} comes again before the angles start over: a repeated position, a sweep back or a re-mounted unit? {give}</source>
            <translation>угол головки {angles} повторяется раньше, чем углы начинаются снова: повторённое положение, обратный проход или переустановленное изделие? {give}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/reader.py" />
            <source>is empty: no rows of measurements</source>
            <translation>пуст: нет строк измерений</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>; this looks like columns parted by commas</source>
            <translation>; это похоже на столбцы, разделённые запятыми</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>{len} columns, {title} has {width}</source>
            <translation>{len} [столбец|столбца|столбцов], {title} имеет {width}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>the rows fit {readings}; keep the beginning of the file's name (OpticalDividingHead_, RotationTable_, Accuracy_) or part the columns by tabs</source>
            <translation>строки подходят к {readings}; сохраните начало имени файла (OpticalDividingHead_, RotationTable_, Accuracy_) или разделите столбцы табуляцией</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>a row of another layout, {title}, among rows of {title2}; a file holds one layout</source>
            <translation>строка другого формата, {title}, среди строк {title2}; файл содержит один формат</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>{why} in {title}</source>
            <translation>{why} в {title}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>(the device's name may be the missing one)</source>
            <translation>(недостающим может быть имя устройства)</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>{title} with the name {name}</source>
            <translation>{title} с именем {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/recognise.py" />
            <source>the columns are those of {title}, the name is that of {title2}: a damaged file, or a wrong name</source>
            <translation>столбцы как у {title}, а имя как у {title2}: повреждённый файл или неверное имя</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/rows.py" />
            <source>the column is empty</source>
            <translation>столбец пуст</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/rows.py" />
            <source>{shown} is no measurement</source>
            <translation>{shown} не является измерением</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/rows.py" />
            <source>{cell} has the decimal mark {mark}, the numbers before it have {first}; use one of them throughout</source>
            <translation>{cell} имеет десятичный знак {mark}, предыдущие числа — {first}; пользуйтесь везде одним из них</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>holds rows of {title}, not of {title2}</source>
            <translation>содержит строки {title}, а не {title2}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} has no columns for a {sensor}</source>
            <translation>в {title} нет столбцов для {sensor}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} holds the test {test}, this run is {test2}</source>
            <translation>{title} содержит испытание {test}, эта серия — {test2}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>the run has no rows</source>
            <translation>в серии нет строк</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} needs outputs of axes x, y, z, this run has {axes}</source>
            <translation>для {title} нужны выходы осей x, y, z, в этой серии {axes}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} holds {len} outputs, not {len2}</source>
            <translation>{title} содержит {len} [выход|выхода|выходов], а не {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>its earlier rows are untouched</source>
            <translation>его прежние строки не тронуты</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>{title} needs the head angle of every row</source>
            <translation>для {title} нужен угол головки каждой строки</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>row {row}: {title} has no position for mount {mount} at {angle} deg</source>
            <translation>строка {row}: в {title} нет положения для установки {mount} на {angle} deg</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>row {place}: {title} needs the {name}, which this run does not hold</source>
            <translation>строка {place}: для {title} нужно {name}, чего эта серия не содержит</translation>
        </message>
        <message>
            <location filename="../../core/records/legacy/writer.py" />
            <source>row {place}, column {column}: {doubt}</source>
            <translation>строка {place}, столбец {column}: {doubt}</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>holds no samples</source>
            <translation>не содержит отсчётов</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>se {name}</source>
            <translation>se {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>holds no means</source>
            <translation>не содержит средних</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>no means after the name of the record</source>
            <translation>после имени записи нет средних</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{len} records, {given} rates or positions for them</source>
            <translation>{len} [запись|записи|записей], {given} [скорость|скорости|скоростей] или положений для них</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>has no output of a gyro</source>
            <translation>не имеет выхода гироскопа</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>the records have different channels</source>
            <translation>у записей разные каналы</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{text} is no position; write X_from:90</source>
            <translation>{text} не является положением; пишите X_from:90</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{len} means; the first line has {len2}</source>
            <translation>{len} средних; в первой строке {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{text} is no number</source>
            <translation>{text} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/records/means.py" />
            <source>{word} is no number</source>
            <translation>{word} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/records/names.py" />
            <source>No Name</source>
            <translation>Без имени</translation>
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
            <translation>Коэффициенты, CSV</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Curves, CSV</source>
            <translation>Кривые, CSV</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Kalibr imu.yaml</source>
            <translation>Kalibr imu.yaml</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>Kalibr needs records in deg/s or m/s^2, not in {units}: state the scale factor</source>
            <translation>Kalibr нужны записи в deg/s или m/s^2, а не в {units}: укажите масштабный коэффициент</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>the records have different rates ({said}): choose those of one device</source>
            <translation>у записей разные частоты ({said}): выберите записи одного устройства</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_exports.py" />
            <source>, upper limit: not detected</source>
            <translation>, верхний предел: не обнаружено</translation>
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
            <translation>{device} {channel}: ни одна модель шума не подходит к записи</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_study.py" />
            <source>{name} cannot be regressed on itself</source>
            <translation>{name} нельзя регрессировать на самого себя</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_study.py" />
            <source>only the curve is given: {error}</source>
            <translation>есть только кривая: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/noise_tables.py" />
            <source>random walk</source>
            <translation>случайное блуждание</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>is a JSON document, no measurements</source>
            <translation>документ JSON, а не измерения</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>mounts are given, but the rows already tell them</source>
            <translation>установки заданы, но строки их уже определяют</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>holds no rows of {device}, only of {device2}</source>
            <translation>не содержит строк {device}, только {device2}</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>holds outputs of the {sensor}, not of the {sensor2}</source>
            <translation>содержит выходы {sensor}, а не {sensor2}</translation>
        </message>
        <message>
            <location filename="../../core/records/open.py" />
            <source>cannot be read: {why}</source>
            <translation>невозможно прочитать: {why}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_file.py" />
            <source>axes {join}; expected x, y or z for each output</source>
            <translation>оси {join}; для каждого выхода ожидается x, y или z</translation>
        </message>
        <message>
            <location filename="../../core/records/run_file.py" />
            <source>a run of test {test} needs a column {name}</source>
            <translation>серии испытания {test} нужен столбец {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_file.py" />
            <source>the further column {name} has the name of another one</source>
            <translation>дополнительный столбец {name} имеет имя другого</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>holds no line of column names</source>
            <translation>не содержит строки с именами столбцов</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>is no run file: the line '# {version_key} = 1' is missing</source>
            <translation>не файл серии: нет строки '# {version_key} = 1'</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>was written by a newer CalRig (run file version {version}; this program reads up to version {version2}): update CalRig</source>
            <translation>записано более новой версией CalRig (файл серии версии {version}; эта программа читает до версии {version2}): обновите CalRig</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>no TOML value: {error}</source>
            <translation>не значение TOML: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>{name} is given twice</source>
            <translation>{name} задано дважды</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>{key} is too large</source>
            <translation>{key} слишком велико</translation>
        </message>
        <message>
            <location filename="../../core/records/run_head.py" />
            <source>notes: expected {severity, subject, text}</source>
            <translation>notes: ожидается {severity, subject, text}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>column {name}: {why}</source>
            <translation>столбец {name}: {why}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>no column of outputs: y, or y_x, y_y, y_z</source>
            <translation>нет столбца выходов: y или y_x, y_y, y_z</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{len} channels are named, {len2} outputs found</source>
            <translation>названо {len} [канал|канала|каналов], найдено {len2} [выход|выхода|выходов]</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>no CSV: {error}</source>
            <translation>не CSV: {error}</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>a column has no name</source>
            <translation>у столбца нет имени</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>column {name} comes twice</source>
            <translation>столбец {name} встречается дважды</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{cell} is no number</source>
            <translation>{cell} не является числом</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{name} is missing</source>
            <translation>{name} отсутствует</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{row} is no whole number</source>
            <translation>{row} не является целым числом</translation>
        </message>
        <message>
            <location filename="../../core/records/run_table.py" />
            <source>{len} cells, the names have {len2}</source>
            <translation>{len} [ячейка|ячейки|ячеек], имён {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/series.py" />
            <source>holds no channel {name}; there are: {names}</source>
            <translation>не содержит канала {name}; есть: {names}</translation>
        </message>
        <message>
            <location filename="../../core/records/series.py" />
            <source>{path} does not tell its sampling rate: state the samples per second</source>
            <translation>{path} не сообщает своей частоты дискретизации: укажите число отсчётов в секунду</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: which channels are the outputs? There are: {names}</source>
            <translation>{path}: какие каналы являются выходами? Есть: {names}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: which channel is the temperature? There are: {names}</source>
            <translation>{path}: какой канал является температурой? Есть: {names}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{lost} of {rows} rows hold no number and were left out</source>
            <translation>{lost} из {rows} [строки|строк|строк] не содержат числа, они пропущены</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: outputs in {join}; take those of one unit at a time</source>
            <translation>{path}: выходы в {join}; берите выходы одной единицы за раз</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>{path}: samples were lost; gaps cannot be averaged over</source>
            <translation>{path}: потеряны отсчёты; через пропуски усреднять нельзя</translation>
        </message>
        <message>
            <location filename="../../core/records/series_run.py" />
            <source>there is no output {output}; there are: {join}</source>
            <translation>выхода {output} нет; есть: {join}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>no row of numbers in the first {min} lines; is it a record?</source>
            <translation>нет строки чисел в первых {min} строках; запись ли это?</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>the first column has no name and increases by {float} each row: it is taken for the time in seconds</source>
            <translation>у первого столбца нет имени, и он растёт на {float} с каждой строкой: он взят за время в секундах</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>holds a test {test}: rows of means, no record of samples</source>
            <translation>содержит испытание {test}: строки средних, а не запись отсчётов</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>is empty: no samples</source>
            <translation>пуст: нет отсчётов</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>{len} cells, the rows before have {len2}</source>
            <translation>{len} [ячейка|ячейки|ячеек], в предыдущих строках {len2}</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>holds time stamps only, no column of samples</source>
            <translation>содержит только отметки времени, ни одного столбца отсчётов</translation>
        </message>
        <message>
            <location filename="../../core/records/series_text.py" />
            <source>column {place}</source>
            <translation>столбец {place}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/events.py" />
            <source>{where}.seconds is no number</source>
            <translation>{where}.seconds не является числом</translation>
        </message>
        <message>
            <location filename="../../core/records/session/events.py" />
            <source>event numbers</source>
            <translation>номера событий</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>line {line}, {size} bytes</source>
            <translation>строка {line}, {size} [байт|байта|байтов]</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>{path}, line {line}: damaged ({size} bytes) and left out; whole events follow it: look at the file and the disk before using this session</source>
            <translation>{path}, строка {line}: повреждена ({size} [байт|байта|байтов]) и пропущена; дальше идут целые события: проверьте файл и диск, прежде чем пользоваться этим сеансом</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>{path}, line {number}</source>
            <translation>{path}, строка {number}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>all positions accepted before are stored, this one is not</source>
            <translation>все принятые ранее положения сохранены, это — нет</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>{path}, line {line}: the program ended while this was being written ({size} bytes); it was never confirmed and is left out, everything before it is whole</source>
            <translation>{path}, строка {line}: программа завершилась во время записи ({size} [байт|байта|байтов]); запись не была подтверждена и пропущена; всё предыдущее цело</translation>
        </message>
        <message>
            <location filename="../../core/records/session/journal.py" />
            <source>what the session holds is untouched</source>
            <translation>то, что содержит сеанс, не тронуто</translation>
        </message>
        <message>
            <location filename="../../core/records/session/legacy_mirror.py" />
            <source>every position is stored in {folder}, but the text file for the old programs could not follow: {error}; it is made anew at the next change</source>
            <translation>каждое положение сохранено в {folder}, но текстовый файл для старых программ не успел за ним: {error}; он будет создан заново при следующем изменении</translation>
        </message>
        <message>
            <location filename="../../core/records/session/legacy_mirror.py" />
            <source>{path}: did not hold the rows of the journal and was made anew; the file as it was found is {name}</source>
            <translation>{path}: не содержал строк журнала и создан заново; найденный файл сохранён как {name}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/lock.py" />
            <source>(process {who} on {who2} since {who3} UTC)</source>
            <translation>(процесс {who} на {who2} с {who3} UTC)</translation>
        </message>
        <message>
            <location filename="../../core/records/session/lock.py" />
            <source>{parent}: another program is measuring into this session{holder}; continue there, or close it and open the session again</source>
            <translation>{parent}: другая программа измеряет в этот сеанс{holder}; продолжайте там или закройте её и откройте сеанс снова</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>no position has been accepted yet</source>
            <translation>ещё не принято ни одного положения</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>the device has no {sensor} that gives other than zero</source>
            <translation>у устройства нет {sensor}, дающего что-либо, кроме нуля</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>the computer's clock was set back between positions {number} and {number2} ({one}, then {other} UTC): their order is right, their times are not; do not judge drift by them</source>
            <translation>часы компьютера переведены назад между положениями {number} и {number2} ({one}, затем {other} UTC): порядок их верен, а время — нет; не судите по нему о дрейфе</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>position {number}: {text}</source>
            <translation>положение {number}: {text}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/record.py" />
            <source>{journal}: events are missing or doubled (numbers {gaps}); somebody changed the file, or the disk lost a part of it</source>
            <translation>{journal}: события отсутствуют или удвоены (номера {gaps}); кто-то изменил файл или диск потерял его часть</translation>
        </message>
        <message>
            <location filename="../../core/records/session/start.py" />
            <source>one of {join} or empty</source>
            <translation>одно из {join} или пусто</translation>
        </message>
        <message>
            <location filename="../../core/records/session/start.py" />
            <source>profile.text does not have the stored hash: it was changed</source>
            <translation>у profile.text не сохранённый хеш: он был изменён</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>{folder}: already holds a session; open it, or choose another folder</source>
            <translation>{folder}: уже содержит сеанс; откройте его или выберите другую папку</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>is no session: it holds no {start_name}</source>
            <translation>не сеанс: нет {start_name}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>the accumulation has other channels than the session</source>
            <translation>у накопления другие каналы, чем у сеанса</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>{title} holds the set temperature of every position</source>
            <translation>{title} содержит заданную температуру каждого положения</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>no positions of these numbers: {sorted}</source>
            <translation>нет положений с такими номерами: {sorted}</translation>
        </message>
        <message>
            <location filename="../../core/records/session/store.py" />
            <source>nothing has been measured yet</source>
            <translation>ещё ничего не измерено</translation>
        </message>
        <message>
            <location filename="../../core/records/text.py" />
            <source>is larger than {max_bytes} MB: no table of means</source>
            <translation>больше {max_bytes} MB: это не таблица средних</translation>
        </message>
        <message>
            <location filename="../../core/records/text.py" />
            <source>holds zero bytes: a binary or UTF-16 file; save it as UTF-8 text and load again</source>
            <translation>содержит нулевые байты: двоичный файл или UTF-16; сохраните его как текст UTF-8 и загрузите снова</translation>
        </message>
        <message>
            <location filename="../../core/records/text.py" />
            <source>is neither UTF-8 nor CP1251 text</source>
            <translation>не текст UTF-8 и не CP1251</translation>
        </message>
        <message>
            <location filename="../../core/records/thermal_exports.py" />
            <source>CSV of the coefficients</source>
            <translation>CSV коэффициентов</translation>
        </message>
        <message>
            <location filename="../../core/records/thermal_exports.py" />
            <source>a record in one orientation compensates this orientation only: no C header is written of it; measure positions at each temperature</source>
            <translation>запись в одном положении компенсирует только это положение: заголовок C из неё не пишется; измерьте положения при каждой температуре</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>of {wanted}</source>
            <translation>из {wanted}</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>cannot accumulate {seconds} s at {rate} samples/s</source>
            <translation>невозможно накапливать {seconds} s при {rate} отсчётах/s</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>nothing has been accumulated</source>
            <translation>ничего не накоплено</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>{lost} of {lost2} samples were lost on the line; the mean is over the rest</source>
            <translation>потеряно на линии {lost} из {lost2} [отсчёта|отсчётов|отсчётов]; среднее взято по остальным</translation>
        </message>
        <message>
            <location filename="../../core/samples/accumulate.py" />
            <source>{join}: the same number in all {x} samples; is the sensor alive, or its noise below one code?</source>
            <translation>{join}: одно и то же число во всех {x} отсчётах; работает ли датчик, или его шум меньше одного кода?</translation>
        </message>
        <message>
            <location filename="../../core/samples/run.py" />
            <source>{x} outputs, {len} names, {len2} axes</source>
            <translation>{x} [выход|выхода|выходов], {len} [имя|имени|имён], {len2} [ось|оси|осей]</translation>
        </message>
        <message>
            <location filename="../../core/samples/run.py" />
            <source>column {name} has {len} rows, y has {x}</source>
            <translation>в столбце {name} {len} [строка|строки|строк], в y {x}</translation>
        </message>
        <message>
            <location filename="../../core/version.py" />
            <source>CalRig {version}</source>
            <translation>CalRig {version}</translation>
        </message>
        <message>
            <location filename="../../drivers/counter.py" />
            <source>counter restarted</source>
            <translation>счётчик начался снова</translation>
        </message>
        <message>
            <location filename="../../drivers/encode.py" />
            <source>only finite values can be sent</source>
            <translation>передавать можно только конечные значения</translation>
        </message>
        <message>
            <location filename="../../drivers/encode.py" />
            <source>there is no encoder for "{name}"</source>
            <translation>нет кодировщика для "{name}"</translation>
        </message>
        <message>
            <location filename="../../drivers/encode.py" />
            <source>data of shape {shape} for {columns} channels</source>
            <translation>данные формы {shape} для {columns} [канала|каналов|каналов]</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>an expression has at most {longest} characters</source>
            <translation>в выражении не более {longest} [символа|символов|символов]</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>"{text}" has no finite value</source>
            <translation>у "{text}" нет конечного значения</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>only numbers, names of [params], + - * / ** and () are allowed</source>
            <translation>разрешены только числа, имена из [params], + - * / ** и ()</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>"{text}" is no expression: {msg}</source>
            <translation>"{text}" не является выражением: {msg}</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>; did you mean "{close}"?</source>
            <translation>; может быть, "{close}"?</translation>
        </message>
        <message>
            <location filename="../../drivers/expression.py" />
            <source>"{name}" is not in [params]{hint}</source>
            <translation>"{name}" нет в [params]{hint}</translation>
        </message>
        <message>
            <location filename="../../drivers/fields.py" />
            <source>no field "{name}"</source>
            <translation>нет поля "{name}"</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>no CalRig record: it does not begin with CALREC1</source>
            <translation>не запись CalRig: не начинается с CALREC1</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>the header of the record is damaged</source>
            <translation>заголовок записи повреждён</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>the header of the record is damaged: it is no JSON object</source>
            <translation>заголовок записи повреждён: не объект JSON</translation>
        </message>
        <message>
            <location filename="../../drivers/framing.py" />
            <source>the header of the record is damaged: {error}</source>
            <translation>заголовок записи повреждён: {error}</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: assembly of nine accelerometers (ClbAcc)</source>
            <translation>Симулированный стенд: сборка из девяти акселерометров (ClbAcc)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: attitude unit PW09 (Pointer)</source>
            <translation>Симулированный стенд: блок ориентации PW09 (Pointer)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: assembly of MEMS gyros (ClbDUS)</source>
            <translation>Симулированный стенд: сборка MEMS-гироскопов (ClbDUS)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>Simulated rig: vibratory gyro CVG25 (CVGCom)</source>
            <translation>Симулированный стенд: вибрационный гироскоп CVG25 (CVGCom)</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>the adapter is not plugged in</source>
            <translation>адаптер не подключён</translation>
        </message>
        <message>
            <location filename="../../drivers/ports.py" />
            <source>plug it in again</source>
            <translation>подключите его снова</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>this program reads schema {schema}, not {schema2}</source>
            <translation>эта программа читает схему {schema}, а не {schema2}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>exactly one of [frame], [line], [protocol] is needed, not {len}</source>
            <translation>нужна ровно одна из [frame], [line], [protocol], а не {len}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>[[field]] belongs to a [frame]</source>
            <translation>[[field]] относится к [frame]</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>must not be negative</source>
            <translation>не может быть отрицательным</translation>
        </message>
        <message>
            <location filename="../../drivers/profile.py" />
            <source>{needed}, which "{name}" needs, is missing or zero</source>
            <translation>{needed}, нужное для "{name}", отсутствует или равно нулю</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>the frame has no checksum to append</source>
            <translation>у кадра нет контрольной суммы для добавления</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>a command needs either hex or ascii</source>
            <translation>команде нужно hex или ascii</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>a command needs at least one byte</source>
            <translation>команде нужен хотя бы один байт</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>the checksum is not at the end of a frame</source>
            <translation>контрольная сумма не в конце кадра</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>is no regular expression: {error}</source>
            <translation>не регулярное выражение: {error}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_commands.py" />
            <source>"{name}" is used twice</source>
            <translation>"{name}" использовано дважды</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>from and to cover no byte</source>
            <translation>from и to не охватывают ни одного байта</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>at {at} leaves no room for {size} bytes</source>
            <translation>на {at} не остаётся места для {size} [байта|байтов|байтов]</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>from and to cover the checksum itself</source>
            <translation>from и to охватывают саму контрольную сумму</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>sum16w needs an even number of bytes, from and to give {len}</source>
            <translation>sum16w требует чётного числа байтов, from и to дают {len}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must not be empty</source>
            <translation>не может быть пустым</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must list at least one baud rate between 50 and 20000000</source>
            <translation>должно перечислять хотя бы одну скорость от 50 до 20000000 бод</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be like "8N1" (data bits, N/E/O, stop bits), not "{form}"</source>
            <translation>должно быть как "8N1" (биты данных, N/E/O, стоп-биты), а не "{form}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be 1 to 8 bytes like "AA 55"; ".." stands for any byte</source>
            <translation>должно быть от 1 до 8 байтов вида "AA 55"; ".." означает любой байт</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must not begin with any byte</source>
            <translation>не может начинаться с произвольного байта</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be a number or an expression, not {value}</source>
            <translation>должно быть числом или выражением, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>min must hold the length field, and max must not be below min</source>
            <translation>min должно вмещать поле длины, а max не может быть меньше min</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>a name must not be empty</source>
            <translation>имя не может быть пустым</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must name at least one value</source>
            <translation>должно называть хотя бы одно значение</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be [lowest, highest] within {kind}</source>
            <translation>должно быть [наименьшее, наибольшее] в пределах {kind}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>can only be taken from an unsigned type</source>
            <translation>можно брать только из беззнакового типа</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must not be zero</source>
            <translation>не может быть нулём</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be at most 4 bytes, none of them the first of sync</source>
            <translation>должно быть не более 4 байтов, ни один из них не первый байт sync</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>needs a checksum; without one let length include these bytes</source>
            <translation>нужна контрольная сумма; без неё пусть length охватывает эти байты</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>needs at least one [[field]] that is not hidden</source>
            <translation>нужно хотя бы одно [[field]], которое не скрыто</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>the fields name "{double}" twice</source>
            <translation>поля дважды называют "{double}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must hold {count} numbers or expressions, one a column</source>
            <translation>должно содержать {count} [число|числа|чисел] или выражений, по одному на столбец</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>names a column twice</source>
            <translation>дважды называет столбец</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must differ from the decimal mark</source>
            <translation>должно отличаться от десятичного знака</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>must be given for style "{style}"</source>
            <translation>должно быть задано для стиля "{style}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>{value} is not one of {allowed}</source>
            <translation>{value} не входит в {allowed}</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>has no "{name}", which this unit replaces</source>
            <translation>нет "{name}", которое эта единица заменяет</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>"{text}" is no row of hexadecimal bytes</source>
            <translation>"{text}" не является рядом шестнадцатеричных байтов</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>has {len} entries for {len2} names</source>
            <translation>{len} [запись|записи|записей] на {len2} [имя|имени|имён]</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>"{role}" is no role</source>
            <translation>"{role}" не является ролью</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>"{role}" needs the unit {join}, not "{unit}"</source>
            <translation>для "{role}" нужна единица {join}, а не "{unit}"</translation>
        </message>
        <message>
            <location filename="../../drivers/profile_sections.py" />
            <source>end at byte {end}, the frame has {shortest}</source>
            <translation>кончаются на байте {end}, в кадре {shortest}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/cvg12.py" />
            <source>gyro {frame} of controller {frame2}</source>
            <translation>гироскоп {frame} контроллера {frame2}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/inertial.py" />
            <source>unknown 0x{message}</source>
            <translation>неизвестное 0x{message}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/inertial.py" />
            <source>command 0x{command}</source>
            <translation>команда 0x{command}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/inertial.py" />
            <source>alignment report</source>
            <translation>отчёт о выставке</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/stim300.py" />
            <source>external trigger</source>
            <translation>внешний запуск</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>hard fault</source>
            <translation>аппаратный отказ</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>serial buffer overflow</source>
            <translation>переполнение буфера порта</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid checksum</source>
            <translation>неверная контрольная сумма</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid command</source>
            <translation>неверная команда</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>not enough parameters</source>
            <translation>слишком мало параметров</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>too many parameters</source>
            <translation>слишком много параметров</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid parameter</source>
            <translation>неверный параметр</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>invalid register</source>
            <translation>неверный регистр</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>unauthorized access</source>
            <translation>нет разрешения</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>watchdog reset</source>
            <translation>сброс сторожевым таймером</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>output buffer overflow</source>
            <translation>переполнение выходного буфера</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>insufficient baud rate</source>
            <translation>недостаточная скорость порта</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>code {code}</source>
            <translation>код {code}</translation>
        </message>
        <message>
            <location filename="../../drivers/protocols/vectornav_ascii.py" />
            <source>register {words}</source>
            <translation>регистр {words}</translation>
        </message>
        <message>
            <location filename="../../drivers/rawlog.py" />
            <source>holds {get}; expected a raw log</source>
            <translation>содержит {get}; ожидается необработанный журнал</translation>
        </message>
        <message>
            <location filename="../../drivers/rawlog.py" />
            <source>not stored</source>
            <translation>не сохранено</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>no data</source>
            <translation>нет данных</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>calrig reader</source>
            <translation>calrig reader</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>the driver does not let go of the port</source>
            <translation>драйвер не отпускает порт</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>unplug the adapter</source>
            <translation>отсоедините адаптер</translation>
        </message>
        <message>
            <location filename="../../drivers/reader.py" />
            <source>stopped by an error inside the program: {fault}</source>
            <translation>остановлено ошибкой в программе: {fault}</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>calrig recorder</source>
            <translation>calrig recorder</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>{path}: the disk has not taken the end of the record for {join_s} s</source>
            <translation>{path}: диск не принял конец записи за {join_s} s</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>other channels</source>
            <translation>другие каналы</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>{path}: the recorder was stopped by an error inside the program ({fault}); what it had stored before is whole: start a new record</source>
            <translation>{path}: запись остановлена ошибкой в программе ({fault}); то, что сохранено раньше, цело: начните новую запись</translation>
        </message>
        <message>
            <location filename="../../drivers/recorder.py" />
            <source>link ended</source>
            <translation>связь завершена</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>its samples have not the {len} channels of its header</source>
            <translation>в его отсчётах нет {len} [канала|каналов|каналов] заголовка</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>the rate of its samples is not known</source>
            <translation>частота его отсчётов неизвестна</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>{count} bytes inside the file are damaged; what they held is a gap.</source>
            <translation>{count} [байт|байта|байтов] внутри файла повреждены; то, что они содержали, — пропуск.</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>The file ends within a block, as after a power cut; all before it is whole.</source>
            <translation>Файл кончается внутри блока, как после отключения питания; всё предыдущее цело.</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>{refused} bytes found no room on the disk while recording.</source>
            <translation>{refused} [байт|байта|байтов] не поместились на диске во время записи.</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>the header names no channels</source>
            <translation>заголовок не называет каналов</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>holds no samples, and no profile that its bytes could be read by</source>
            <translation>не содержит ни отсчётов, ни профиля, по которому можно прочитать его байты</translation>
        </message>
        <message>
            <location filename="../../drivers/recording.py" />
            <source>was interrupted, and too little came to tell how long by</source>
            <translation>прервано, и пришло слишком мало, чтобы сказать, на какое время</translation>
        </message>
        <message>
            <location filename="../../drivers/records.py" />
            <source>holds no records of CVGCom and no recordings</source>
            <translation>не содержит ни записей CVGCom, ни записей программы</translation>
        </message>
        <message>
            <location filename="../../drivers/series.py" />
            <source>the record was not ended in order; what stands in it is whole</source>
            <translation>запись не была завершена как следует; то, что в ней есть, цело</translation>
        </message>
        <message>
            <location filename="../../drivers/series.py" />
            <source>holds no samples yet</source>
            <translation>ещё не содержит отсчётов</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/analysis.py" />
            <source>nothing was found that a device file could say</source>
            <translation>не найдено ничего, что мог бы сказать файл устройства</translation>
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
            <translation>время в секундах</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>the time in milliseconds</source>
            <translation>время в миллисекундах</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>the time in microseconds</source>
            <translation>время в микросекундах</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>{address} does not run in real time</source>
            <translation>{address} работает не в реальном времени</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>its bytes came faster than {baud} baud can carry</source>
            <translation>его байты пришли быстрее, чем их могут передать {baud} бод</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>no times of its bytes are known</source>
            <translation>моменты прихода байтов неизвестны</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>{doubt}, and none of its numbers is the time</source>
            <translation>{doubt}, и ни одно из чисел не является временем</translation>
        </message>
        <message>
            <location filename="../../drivers/teach/pace.py" />
            <source>{doubt}; {name} is {unit}, by which it is {hz} a second</source>
            <translation>{doubt}; {name} — это {unit}, откуда выходит {hz} в секунду</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>is missing</source>
            <translation>отсутствует</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a text in quotes, not {value}</source>
            <translation>должно быть текстом в кавычках, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a whole number, not {value}</source>
            <translation>должно быть целым числом, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be between {low} and {high}, not {value}</source>
            <translation>должно быть между {low} и {high}, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a finite number, not {value}</source>
            <translation>должно быть конечным числом, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be true or false, not {value}</source>
            <translation>должно быть true или false, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a list, [...], not {value}</source>
            <translation>должно быть списком, [...], а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>every entry must be a text in quotes</source>
            <translation>каждый элемент должен быть текстом в кавычках</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>every entry must be a whole number</source>
            <translation>каждый элемент должен быть целым числом</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be a table, not {value}</source>
            <translation>должно быть таблицей, а не {value}</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>must be [[{key}]] sections</source>
            <translation>должно быть разделами [[{key}]]</translation>
        </message>
        <message>
            <location filename="../../drivers/toml_table.py" />
            <source>is no key of this table{hint}</source>
            <translation>не является ключом этой таблицы{hint}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port does not open: {text}</source>
            <translation>порт не открывается: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>there is no such port: {text}</source>
            <translation>такого порта нет: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port vanished: {error}</source>
            <translation>порт исчез: {error}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the adapter was unplugged or lost power; plug it in again</source>
            <translation>адаптер отсоединён или потерял питание; подключите его снова</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port is busy: another program has it open</source>
            <translation>порт занят: его открыла другая программа</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>close that program and try again</source>
            <translation>закройте ту программу и попробуйте снова</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>permission denied: this user may not open the port</source>
            <translation>нет разрешения: этот пользователь не может открыть порт</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>sudo usermod -aG dialout $USER, then log in again</source>
            <translation>sudo usermod -aG dialout $USER, затем войдите снова</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>there is no such port</source>
            <translation>такого порта нет</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>plug the adapter in and refresh the list</source>
            <translation>подключите адаптер и обновите список</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>nobody answers there: {text}</source>
            <translation>там никто не отвечает: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>check the address and the port</source>
            <translation>проверьте адрес и порт</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>onfigure port</source>
            <translation>onfigure port</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port does not take {baud} baud {form}, or is no serial port ({text})</source>
            <translation>порт не принимает {baud} baud {form} или не является последовательным ({text})</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>choose another baud rate or another port</source>
            <translation>выберите другую скорость или другой порт</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the port does not take {baud} baud ({text})</source>
            <translation>порт не принимает {baud} baud ({text})</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>choose another baud rate</source>
            <translation>выберите другую скорость</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>there is no such port: {kind}:// is unknown</source>
            <translation>такого порта нет: {kind}:// неизвестен</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>expected a port name, socket://, sim:// or replay://</source>
            <translation>ожидается имя порта, socket://, sim:// или replay://</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>the device takes no data</source>
            <translation>устройство не принимает данных</translation>
        </message>
        <message>
            <location filename="../../drivers/transport.py" />
            <source>check the cable and the flow control</source>
            <translation>проверьте кабель и управление потоком</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/address.py" />
            <source>unknown key {key}; there are {join}</source>
            <translation>неизвестный ключ {key}; есть {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>no device {device_id}; there are {join}</source>
            <translation>устройства {device_id} нет; есть {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>no effect {effect_id}; there are {join}</source>
            <translation>эффекта {effect_id} нет; есть {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>effect {effect_id} acts between rows; a rig plays what acts at once</source>
            <translation>эффект {effect_id} действует между строками; стенд играет то, что действует сразу</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>effect {effect_id} takes {len} values ({names})</source>
            <translation>эффект {effect_id} принимает {len} [значение|значения|значений] ({names})</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>no output {role}; there are {join}</source>
            <translation>выхода {role} нет; есть {join}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/devices.py" />
            <source>MiniAhrs 2.12</source>
            <translation>MiniAhrs 2.12</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/orders.py" />
            <source>unknown order {join}; there are {join2}</source>
            <translation>неизвестный приказ {join}; есть {join2}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/orders.py" />
            <source>stuck: there are {len} channels</source>
            <translation>stuck: каналов {len}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_replay.py" />
            <source>speed={query} must be above zero, or max</source>
            <translation>speed={query} должно быть больше нуля или max</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_replay.py" />
            <source>there is no file {path}</source>
            <translation>файла {path} нет</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_sim.py" />
            <source>{url} is unplugged</source>
            <translation>{url} отсоединён</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_sim.py" />
            <source>{url} is open</source>
            <translation>{url} открыт</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/protocol_sim.py" />
            <source>the simulated cable was pulled</source>
            <translation>симулированный кабель выдернули</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/rig.py" />
            <source>axis {axis}; expected x, y or z</source>
            <translation>ось {axis}; ожидается x, y или z</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/session.py" />
            <source>{group}, step {number}: {text}</source>
            <translation>{group}, шаг {number}: {text}</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/session.py" />
            <source>the rig ended</source>
            <translation>стенд завершил работу</translation>
        </message>
        <message>
            <location filename="../../drivers/virtual/truth.py" />
            <source>{held} of {len} intervals (95 %) hold the truth</source>
            <translation>{held} из {len} [интервала|интервалов|интервалов] (95 %) содержат истинное значение</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>column</source>
            <translation>столбец</translation>
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
            <translation>курсы</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>line</source>
            <translation>строка</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>now</source>
            <translation>сейчас</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>problem</source>
            <translation>неисправность</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>rate</source>
            <translation>скорость</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>rates</source>
            <translation>скорости</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>row</source>
            <translation>строка</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>turn-on</source>
            <translation>включение</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>session</source>
            <translation>сеанс</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>calibration</source>
            <translation>калибровка</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>legacy</source>
            <translation>старый файл</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>record</source>
            <translation>запись</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>means</source>
            <translation>средние</translation>
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
            <translation>хорошо</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>doubt</source>
            <translation>сомнение</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>bad</source>
            <translation>плохие</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>damaged</source>
            <translation>повреждён</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>bias</source>
            <translation>смещение нуля</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>differs</source>
            <translation>отличается</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>cross axis x</source>
            <translation>поперечная ось x</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>cross axis y</source>
            <translation>поперечная ось y</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>cross axis z</source>
            <translation>поперечная ось z</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Saturation</source>
            <translation>Насыщение</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Warm-up</source>
            <translation>Прогрев</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Outlier</source>
            <translation>Выброс</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Drop-outs</source>
            <translation>Пропуски</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Clipping</source>
            <translation>Ограничение</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>Hysteresis</source>
            <translation>Гистерезис</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} files</source>
            <translation>файлов: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} headings</source>
            <translation>курсов: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} positions</source>
            <translation>положений: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} rates</source>
            <translation>скоростей: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} rows</source>
            <translation>строк: {n}</translation>
        </message>
        <message>
            <location filename="../../gui/languages/plain_texts.py" />
            <source>{n} samples</source>
            <translation>отсчётов: {n}</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_4.toml" />
            <source>4 positions about X</source>
            <translation>4 положения вокруг X</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_4.toml" />
            <source>Rotation Around X axis, X from ODH</source>
            <translation>Rotation Around X axis, X from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_8.toml" />
            <source>8 positions about X and Y</source>
            <translation>8 положений вокруг X и Y</translation>
        </message>
        <message>
            <location filename="../../resources/plans/accelerometer_8.toml" />
            <source>Rotation Around Y axis, Y from ODH</source>
            <translation>Rotation Around Y axis, Y from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/clbacc_24.toml" />
            <source>15-degree steps, about X and Y</source>
            <translation>Шаги по 15 градусов, вокруг X и Y</translation>
        </message>
        <message>
            <location filename="../../resources/plans/drift_turn_on.toml" />
            <source>5 turn-ons at each temperature, drift after switching on</source>
            <translation>5 включений при каждой температуре, дрейф после включения</translation>
        </message>
        <message>
            <location filename="../../resources/plans/drift_turn_on.toml" />
            <source>Turn-ons, unit at rest</source>
            <translation>Включения, изделие в покое</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_400.toml" />
            <source>Fourier tumble, 5 to 400 deg by 5</source>
            <translation>Оборот по Фурье, от 5 до 400 deg через 5</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_400.toml" />
            <source>Tumble about Z, X level at 0</source>
            <translation>Оборот вокруг Z, X горизонтально на 0</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_flip.toml" />
            <source>Fourier tumble, upright and turned over, 15 to 375 deg by 15</source>
            <translation>Оборот по Фурье, прямо и перевёрнуто, от 15 до 375 deg через 15</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_flip.toml" />
            <source>Upright: Y up at 0</source>
            <translation>Прямо: Y вверх на 0</translation>
        </message>
        <message>
            <location filename="../../resources/plans/fourier_flip.toml" />
            <source>Turned over: Y down at 0</source>
            <translation>Перевёрнуто: Y вниз на 0</translation>
        </message>
        <message>
            <location filename="../../resources/plans/g_sensitivity_4.toml" />
            <source>g-sensitivity of gyros, 4 positions about X</source>
            <translation>g-чувствительность гироскопов, 4 положения вокруг X</translation>
        </message>
        <message>
            <location filename="../../resources/plans/g_sensitivity_8.toml" />
            <source>g-sensitivity of gyros, 8 positions about X and Y</source>
            <translation>g-чувствительность гироскопов, 8 положений вокруг X и Y</translation>
        </message>
        <message>
            <location filename="../../resources/plans/gyrocompass_4.toml" />
            <source>Gyrocompass, steps of 90 deg</source>
            <translation>Гирокомпас, шаги по 90 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/gyrocompass_4.toml" />
            <source>Gyro on a level base, input axis level</source>
            <translation>Гироскоп на горизонтальном основании, входная ось горизонтальна</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy.toml" />
            <source>Accuracy, pitch 0 to 360 deg</source>
            <translation>Точность, тангаж от 0 до 360 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy.toml" />
            <source>Pitch, X from ODH</source>
            <translation>Тангаж, X from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy_3.toml" />
            <source>Accuracy, pitch 0, 30, 60 deg</source>
            <translation>Точность, тангаж 0, 30, 60 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pitch_accuracy_45.toml" />
            <source>Accuracy, pitch 0 to 360 deg by 45</source>
            <translation>Точность, тангаж от 0 до 360 deg через 45</translation>
        </message>
        <message>
            <location filename="../../resources/plans/pointer_16.toml" />
            <source>Pointer, 16 positions</source>
            <translation>Pointer, 16 положений</translation>
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
            <translation>Pointer, положения 1-4 и 13-16</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_100.toml" />
            <source>Rate table, -100 to 100 deg/s, about Z</source>
            <translation>Поворотный стол, от -100 до 100 deg/s, вокруг Z</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_100.toml" />
            <source>Rotation Around Axis, Z up</source>
            <translation>Rotation Around Axis, Z up</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_cvg40.toml" />
            <source>Rate table, -40 to 40 deg/s, about Z, for a CVG</source>
            <translation>Поворотный стол, от -40 до 40 deg/s, вокруг Z, для CVG</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Rate table, up and down twice, -100 to 100 deg/s, about Z</source>
            <translation>Поворотный стол, дважды вверх и вниз, от -100 до 100 deg/s, вокруг Z</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Rising rates, first sweep, Z up</source>
            <translation>Растущие скорости, первый проход, Z вверх</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Falling rates, first sweep, Z up</source>
            <translation>Убывающие скорости, первый проход, Z вверх</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Rising rates, second sweep, Z up</source>
            <translation>Растущие скорости, второй проход, Z вверх</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_up_down.toml" />
            <source>Falling rates, second sweep, Z up</source>
            <translation>Убывающие скорости, второй проход, Z вверх</translation>
        </message>
        <message>
            <location filename="../../resources/plans/rate_table_xyz.toml" />
            <source>Rate table, all three axes by re-mounting, -100 to 100 deg/s</source>
            <translation>Поворотный стол, все три оси переустановкой, от -100 до 100 deg/s</translation>
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
            <translation>Точность, крен от 0 до 360 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy.toml" />
            <source>Roll, Y from ODH</source>
            <translation>Крен, Y from ODH</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy_3.toml" />
            <source>Accuracy, roll 0, 30, 60 deg</source>
            <translation>Точность, крен 0, 30, 60 deg</translation>
        </message>
        <message>
            <location filename="../../resources/plans/roll_accuracy_45.toml" />
            <source>Accuracy, roll 0 to 360 deg by 45</source>
            <translation>Точность, крен от 0 до 360 deg через 45</translation>
        </message>
        <message>
            <location filename="../../resources/plans/six_positions.toml" />
            <source>6 orthogonal positions</source>
            <translation>6 ортогональных положений</translation>
        </message>
        <message>
            <location filename="../../resources/plans/thermal_8.toml" />
            <source>8 positions at each temperature of the cycle</source>
            <translation>8 положений при каждой температуре цикла</translation>
        </message>
    </context>
    <context>
        <name>SourceView</name>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Stop listening</source>
            <translation>Прекратить</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Listen</source>
            <translation>Слушать</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Port</source>
            <translation>Порт</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>BaudRate</source>
            <translation>Скорость</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Find speed</source>
            <translation>Найти скорость</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Listens at each baud rate until the bytes make sense; nothing is sent</source>
            <translation>Слушает на каждой скорости, пока байты не обретут смысл; ничего не передаётся</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Raw log…</source>
            <translation>Журнал…</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Take the bytes of a raw log, a recording, or any file</source>
            <translation>Взять байты из необработанного журнала, записи или любого файла</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Find layout</source>
            <translation>Найти строение</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Looks for frames, checksum and numbers in the latest bytes (F5)</source>
            <translation>Ищет кадры, контрольную сумму и числа в последних байтах (F5)</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Hold</source>
            <translation>Удержать</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Opens the port and only listens; nothing is sent</source>
            <translation>Открывает порт и только слушает; ничего не передаётся</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Raw bytes</source>
            <translation>Необработанные байты</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>Raw logs and recordings (*.calrec)</source>
            <translation>Необработанные журналы и записи (*.calrec)</translation>
        </message>
        <message>
            <location filename="../../gui/frames/source_view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
    </context>
    <context>
        <name>StripCharts</name>
        <message>
            <location filename="../../gui/widgets/strip_charts.py" />
            <source>Charts</source>
            <translation>Графики</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/strip_charts.py" />
            <source>Arrows move, plus and minus zoom, Home shows all, End tracks, A and B set cursors</source>
            <translation>Стрелки двигают, плюс и минус масштабируют, Home показывает всё, End следит, A и B ставят курсоры</translation>
        </message>
    </context>
    <context>
        <name>ThermalView</name>
        <message>
            <location filename="../../gui/thermal/view.py" />
            <source>Positions and records (*.run.csv *.txt *.csv *.dat *.calrec session.json)</source>
            <translation>Положения и записи (*.run.csv *.txt *.csv *.dat *.calrec session.json)</translation>
        </message>
        <message>
            <location filename="../../gui/thermal/view.py" />
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
    </context>
    <context>
        <name>ToolsView</name>
        <message>
            <location filename="../../gui/live/tools_view.py" />
            <source>Point on chart</source>
            <translation>Точек на график</translation>
        </message>
        <message>
            <location filename="../../gui/live/tools_view.py" />
            <source>Decimation (table)</source>
            <translation>Прореживание (табл.)</translation>
        </message>
        <message>
            <location filename="../../gui/live/tools_view.py" />
            <source>Display only: the record is never decimated</source>
            <translation>Только для показа: запись никогда не прореживается</translation>
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
            <translation>Ваш ответ: {names}</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Look at the residuals against each regressor, tick what you think is hidden (nothing, one effect or two), and reveal.</source>
            <translation>Посмотрите остатки по каждому регрессору, отметьте, что, по-вашему, скрыто (ничего, один эффект или два), и откройте.</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Names to choose from</source>
            <translation>Названия на выбор</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Reveal</source>
            <translation>Открыть</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>Next Case</source>
            <translation>Следующий случай</translation>
        </message>
        <message>
            <location filename="../../gui/discrepancy/trial_view.py" />
            <source>The next case is</source>
            <translation>Следующий случай —</translation>
        </message>
    </context>
    <context>
        <name>TumbleSide</name>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Output</source>
            <translation>Выход</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Which accelerometer; its axis must turn with the head.</source>
            <translation>Какой акселерометр; его ось должна вращаться с головкой.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Harmonics</source>
            <translation>Гармоники</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>The third shows a nonlinearity of third order.</source>
            <translation>Третья показывает нелинейность третьего порядка.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Local g</source>
            <translation>Местное g</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>1 where the readings are to be told per g.</source>
            <translation>1, если показания следует давать в g.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>u(g)</source>
            <translation>u(g)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Standard uncertainty, k = 1.</source>
            <translation>Стандартная неопределённость, k = 1.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>u(head)</source>
            <translation>u(головки)</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Standard uncertainty of one setting of the head.</source>
            <translation>Стандартная неопределённость одной установки головки.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Fit a steady drift</source>
            <translation>Оценить равномерный дрейф</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Over the run, along with the series.</source>
            <translation>За серию, вместе с рядом.</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>Signs of the paper</source>
            <translation>Знаки статьи</translation>
        </message>
        <message>
            <location filename="../../gui/tumble/side_view.py" />
            <source>k_x and k_y for the projection of gravity instead of specific force.</source>
            <translation>k_x и k_y для проекции силы тяжести вместо кажущегося ускорения.</translation>
        </message>
    </context>
    <context>
        <name>WindowMenu</name>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Go to</source>
            <translation>Перейти к</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Look</source>
            <translation>Вид</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Sounds</source>
            <translation>Звуки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Help</source>
            <translation>Справка</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Distance view</source>
            <translation>Вид издалека</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Preferences</source>
            <translation>Настройки</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Keys</source>
            <translation>Клавиши</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Tour of the window</source>
            <translation>Обзор окна</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Next tab</source>
            <translation>Следующая вкладка</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Tab before</source>
            <translation>Предыдущая вкладка</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Light</source>
            <translation>Светлый</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Dark</source>
            <translation>Тёмный</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>As the system</source>
            <translation>Как в системе</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Off</source>
            <translation>Выключено</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Quiet</source>
            <translation>Тихо</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Normal</source>
            <translation>Обычно</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Loud</source>
            <translation>Громко</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/window_menu.py" />
            <source>Language</source>
            <translation>Язык</translation>
        </message>
    </context>
    <context>
        <name>_Model</name>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Name</source>
            <translation>Имя</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Bytes</source>
            <translation>Байты</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Type</source>
            <translation>Тип</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Course</source>
            <translation>Ход</translation>
        </message>
        <message>
            <location filename="../../gui/frames/fields_view.py" />
            <source>Looks like</source>
            <translation>Похоже на</translation>
        </message>
    </context>
    <context>
        <name>_Next</name>
        <message>
            <location filename="../../gui/widgets/stage.py" />
            <source>Next</source>
            <translation>Далее</translation>
        </message>
    </context>
    <context>
        <name>_View</name>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Copy</source>
            <translation>Копировать</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Copy as CSV (1.5, …)</source>
            <translation>Копировать как CSV (1.5, …)</translation>
        </message>
        <message>
            <location filename="../../gui/widgets/result_table.py" />
            <source>Copy as CSV (1,5; …)</source>
            <translation>Копировать как CSV (1,5; …)</translation>
        </message>
    </context>
</TS>
