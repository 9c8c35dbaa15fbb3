"""Kinds of files that people have, two or more of each, and what `read` makes of them by the lesson's own line.

A row: name, text, the column of the time stamps, and either (seconds, {column: readings}) or words of the sentence.
The kinds are those of 39 real files; the texts are made up.
"""

nan = float("nan")
DAY, HOUR, MONTH, YEAR = 86400, 3600, 2_629_746, 31_556_952

LOGGER = '"TOA5","Meadow","LOG1","0001","Std.1","CPU:a.CR1","1","Hourly"\n"TIMESTAMP","RECORD","Batt","AirT"\n'
LOGGER += '"TS","RN","Volts","Deg C"\n"","","Min","Avg"\n'
LOGGER += '"2026-04-01 00:00:00",0,13.0,7.1\n"2026-04-01 01:00:00",1,13.1,"NAN"\n"2026-04-01 02:00:00",2,13.0,6.5\n'
LONG = "t,name,value\n0,a,1\n0,b,5\n1,a,2\n1,b,6\n2,a,3\n2,b,7\n"
SHIPS = "time,ship,speed\n" + "".join(f"2026-04-01T12:0{m}:00Z,{s},{m + s % 7}\n" for m in range(4) for s in (211, 316))
FORWARD = "".join(f"2026-03-29 {clock},{k}\n" for k, clock in enumerate(("01:30", "01:40", "01:50", "03:00", "03:10")))
BACK = "".join(f"2026-10-25 {clock},{k}\n" for k, clock in enumerate(("02:30", "02:50", "02:10", "02:30")))
HMS = "".join(f"{120000 + 100 * (k // 60) + k % 60}.00,{k}\n" for k in range(30, 100))

READ = [
    # equal short names, axes in brackets
    ("axes in brackets", "Time (s), G(x), G(y),V (OBD)(km/h)\n0,0.02,0.01,12\n1,0.03,0.02,13\n", "Time",
     ([0, 1], {"G(x)": [0.02, 0.03], "G(y)": [0.01, 0.02], "V (OBD)": [12, 13]})),
    ("one name, two units", "t [s],T [K],T [°C]\n0,280,6.85\n2,281,7.85\n", "t", ([0, 2], {"T [°C]": [6.85, 7.85]})),
    # a nameless first column
    ("pandas' index", ",height\n2026-04-01 10:00:00,1.52\n2026-04-01 10:00:01,1.49\n", "Unnamed: 0",
     ([0, 1], {"height": [1.52, 1.49]})),
    ("R's row names", '"","t [s]","x"\n"1",0,5\n"2",0.5,6\n', "t", ([0, 0.5], {"x": [5, 6]})),
    # columns of text
    ("provider and comment", "time [s],lat,provider,note\n0,45.1,gps,\n1,45.2,network,slow\n", "time",
     ([0, 1], {"lat": [45.1, 45.2]})),
    ("flags and dashes", "Timestamp,h,T,ok\n2026-04-01 16:35:39.5,0.1,--.--,true\n2026-04-01 16:35:40,0.2,--.--,true\n",
     "Timestamp", ([0, 0.5], {"h": [0.1, 0.2]})),
    # preamble, row of units
    ("a logger's four lines", LOGGER, "TIMESTAMP", ([0, HOUR, 2 * HOUR], {"AirT": [7.1, nan, 6.5]})),
    ("a station's preamble", "Station: Hill\nHeight: 312 m\n\ndate;T\n2026-04-01;7,5\n2026-04-02;8,25\n", "date",
     ([0, DAY], {"T": [7.5, 8.25]})),
    ("a row of units", "t,u,v\nms,m/s,m/s\n0,1.5,2\n20,1.6,2.1\n", "t", ([0, 0.02], {"u": [1.5, 1.6]})),
    # dates as numbers
    ("yyyymmdd", "date,level\n20260118,3.10\n20260125,3.12\n20260201,3.15\n", "date", ([0, 7 * DAY, 14 * DAY],
     {"level": [3.1, 3.12, 3.15]})),
    ("yyyymmddhhmm", "date,level\n202602282300,1\n202603010000,2\n202603010100,3\n", "date", ([0, HOUR, 2 * HOUR], {})),
    # ISO in its forms; months, weeks and years
    ("year and month", "month,flow\n1871-01,1120\n1871-02,1160\n1871-03,963\n", "month", ([0, MONTH, 2 * MONTH],
     {"flow": [1120, 1160, 963]})),
    ("years", "year,flow\n1871,1120\n1872,1160\n1873,963\n", "year", ([0, YEAR, 2 * YEAR], {"flow": [1120, 1160,
     963]})),
    ("quarters", "when,gdp\n1999Q4,1.5\n2000Q1,1.6\n2000Q2,1.7\n", "when", ([0, 3 * MONTH, 6 * MONTH], {})),
    ("weeks", "week,cases\n2026-W52,5\n2026-W53,6\n2027-W01,7\n", "week", ([0, 7 * DAY, 14 * DAY], {"cases": [5, 6,
     7]})),
    ("day of the year", "day,T\n2026-059,5\n2026-060,6\n", "day", ([0, DAY], {})),
    ("nine digits", "t,x\n2026-03-01T12:00:00.123456789,1\n2026-03-01T12:00:00.123457789,2\n", "t", ([0, 1e-6], {})),
    ("basic form", "t,x\n20260503T081400Z,1\n20260503T081402Z,2\n", "t", ([0, 2], {})),
    # other dates, of which one reading fits
    ("day first, shown by the 31st", "t;x\n31.05.2026 23:59;1,5\n01.06.2026 00:00;2\n", "t", ([0, 60], {"x": [1.5,
     2]})),
    ("month first, with AM", "t,x\n5/31/2026 11:59 PM,1\n6/1/2026 12:00 AM,2\n", "t", ([0, 60], {})),
    ("names of months", "t,x\n31-May-2026 10:00:00,1\n01-Jun-2026 10:00:00,2\n", "t", ([0, DAY], {})),
    ("year first with slashes", "t,x\n2026/05/31 10:00:00,1\n2026/05/31 10:00:01,2\n", "t", ([0, 1], {})),
    # newest first
    ("newest first", "Date,Close\n2026-04-08,106.49\n2026-04-07,105.61\n2026-04-03,106.18\n", "Date",
     ([0, 4 * DAY, 5 * DAY], {"Close": [106.18, 105.61, 106.49]})),
    # clocks without a date; counters
    ("hours, minutes, seconds", "t,x\n09:59:59.5,1\n10:00:00,2\n", "t", ([0, 0.5], {})),
    ("whole nanoseconds", "t [ns],x\n1772366400123456789,1\n1772366400123457789,2\n1772366400123458789,3\n", "t",
     ([0, 1e-6, 2e-6], {})),
    ("microseconds since 1970", "t [us],x\n1772366400000001,1\n1772366400000002,2\n", "t", ([0, 1e-6], {})),
    # a sensor that is stuck, gaps of three kinds, decimal commas
    ("stuck at rest", "t [s],level [V]\n0,0.00\n1,0.00\n2,0.02\n", "t", ([0, 1, 2], {"level": [0, 0, 0.02]})),
    ("decimal commas", "t [s]\tx\n0,5\t1,25\n1,5\tNA\n2,5\t-3\n", "t", ([0, 1, 2], {"x": [1.25, nan, -3]})),
    ("zones that change", "t,x\n2026-03-29T01:59:59+01:00,1\n2026-03-29T03:00:00+02:00,2\n", "t", ([0, 1], {})),
    ("Windows' ends of lines", "t [s];x\r\n0;1\r\n1;\r\n2;3\r\n", "t", ([0, 1, 2], {"x": [1, nan, 3]})),
]  # fmt: skip

# What cannot be read without a word from the learner: the words, the options, and what is read with them.
ASKED = [
    ("two rows in a millisecond",
     "t,x\n2026-04-01 10:00:00.412,1\n2026-04-01 10:00:00.443,2\n2026-04-01 10:00:00.443,4\n", "t",
     "line 4: the time stamp '2026-04-01 10:00:00.443' repeats that of line 3: equal='keep' or 'merge'",
     dict(equal="merge"), ([0, 0.031], {"x": [1, 3]})),
    ("whole seconds at 2 Hz", "t [s],x\n5,1\n5,2\n6,3\n6,4\n", "t", "repeats that of line 2: equal='keep'",
     dict(equal="keep"), ([0, 0, 1, 1], {"x": [1, 2, 3, 4]})),
    ("date and clock", "Date,Time,T\n2026-04-01,23:30:00,1\n2026-04-01,23:45:00,2\n2026-04-02,00:00:00,3\n", "Date",
     "time=('Date', 'Time')", dict(time=("Date", "Time")), ([0, 900, 1800], {"T": [1, 2, 3]})),
    ("date and clock, German", "Datum;Zeit;T\n01.05.2026;18:00;1,5\n01.05.2026;19:00;2\n", ("Datum", "Zeit"),
     "dayfirst=True or dayfirst=False", dict(dayfirst=True), ([0, HOUR], {"T": [1.5, 2]})),
    ("ambiguous slashes", "t,x\n01/02/2026,1\n02/02/2026,2\n", "t", "dayfirst=True or dayfirst=False",
     dict(dayfirst=False), ([0, 31 * DAY], {})),
    ("own format", "t,x\n26-W10 3 h,1\n26-W10 4 h,2\n", "t", "is no date as in ISO 8601",
     dict(time_format="%y-W10 %H h"),
     ([0, HOUR], {})),
    ("yyyymmdd under [d]", "t [d],x\n20260131,1\n20260201,2\n", "t", "look like dates: time_format='%Y%m%d'",
     dict(time_format="%Y%m%d"), ([0, DAY], {})),
    ("yyyymm", "t,x\n202601,1\n202602,2\n202603,3\n", "t", "look like dates: time_format='%Y%m'",
     dict(time_format="%Y%m"),
     ([0, 31 * DAY, 59 * DAY], {})),
    ("hhmmss under utc [s]", "utc [s],x\n" + HMS, "utc", "look like hours, minutes, seconds: time_format='%H%M%S'",
     dict(time_format="%H%M%S.%f"), (list(range(70)), {})),
    ("hhmmss, nobody says so", "t [s],x\n" + HMS, "t", "look like hours, minutes, seconds", dict(time_unit="s"),
     ([k + 40 * (k >= 30) for k in range(70)], {})),
    ("hhmmss without its zeros", "clock,x\n5958,1\n5959,2\n10000,3\n", "clock", "look like hours, minutes, seconds",
     dict(time_format="%H%M%S"), ([0, 1, 2], {})),
    ("micros() runs over", "micros [us],d\n4294900000,31.2\n4294950000,31.4\n32704,31.3\n82704,31.6\n", "micros",
     "does the counter run over? wraps=4294967296", dict(wraps=2**32), ([0, 0.05, 0.1, 0.15], {})),
    ("time of week", "tow [s],x\n604798,1\n604799,2\n0,3\n1,4\n", "tow", "wraps=604800", dict(wraps=604800), ([0, 1, 2,
     3], {})),
    ("clock over midnight", "t,x\n23:59:58,1\n23:59:59,2\n00:00:00,3\n", "t", "wraps=86400", dict(wraps=86400), ([0, 1,
     2], {})),
    ("rows out of order", "t [s],x\n0,1\n2,3\n1,2\n", "t", "lies before that of line 3: sort=True", dict(sort=True),
     ([0, 1, 2], {"x": [1, 2, 3]})),
    ("several ships", SHIPS, "time", "several objects? where={'ship': 211}", dict(where={"ship": 316}),
     ([0, 60, 120, 180], {"speed": [1, 2, 3, 4]})),
    ("one reading a row", LONG.replace("t,", "t [s],"), "t", "one reading a row? pivot=('name', 'value')",
     dict(pivot=("name", "value"), equal="merge"), ([0, 1, 2], {"a": [1, 2, 3], "b": [5, 6, 7]})),
    ("clocks put forward", "t,x\n" + FORWARD, "t", "comes an hour late: did the clocks change here?",
     dict(zone="Europe/Berlin"), ([0, 600, 1200, 1800, 2400], {})),
    ("clocks put back", "t,x\n" + BACK, "t", "zone='Europe/Berlin'", dict(zone="Europe/Berlin"), ([0, 1200, 2400,
     3600], {})),
    ("no unit", "t,x\n1772366400123,1\n1772366400223,2\n", "t", "such numbers are ms since 1970: time_unit='ms'",
     dict(time_unit="ms"), ([0, 0.1], {})),
    ("a mark of one's own", "t [s],x\n0,1\n1,---\n2,3\n", "t",
     "column 'x': '---' is no number (no reading? missing=['---'])",
     dict(missing=["---"]), ([0, 1, 2], {"x": [1, nan, 3]})),
    ("thousands", 't [s],x\n0,1\n1,"1,234.5"\n2,3\n', "t", "has separators of thousands: thousands=','",
     dict(thousands=","),
     ([0, 1, 2], {"x": [1, 1234.5, 3]})),
    ("columns by spaces", "t x\n0  1\n1  2\n", "t", "separator=' ' reads columns with spaces", dict(separator=" ",
     time_unit="s"),
     ([0, 1], {"x": [1, 2]})),
    ("no header", "0,1\n1,2\n", "t", "header=False names them column 1", dict(header=False, time="column 1",
     time_unit="s"),
     ([0, 1], {"column 2": [1, 2]})),
    ("header in a comment", "# logger\n# t [s],x\n0,1\n1,2\n", "t", "the names of the columns are missing",
     dict(header=2),
     ([0, 1], {"x": [1, 2]})),
    ("leap second", "t,x\n2016-12-31T23:59:59Z,1\n2016-12-31T23:59:60Z,2\n2017-01-01T00:00:00Z,3\n", "t",
     "line 3: the time stamp '2016-12-31T23:59:60Z' is a leap second", None, None),
    ("JSON", '{"t": [0, 1], "x": [1, 2]}', "t", "this is JSON, not a table", None, None),
    ("HTML", "<!DOCTYPE html>\n<table></table>", "t", "this is XML or HTML, not a table", None, None),
    ("AIS", "!AIVDM,1,1,,B,15M67F,0*73\n!AIVDM,1,1,,B,15M67F,0*73\n", "t", "the package pyais decodes them", None,
     None),
    ("zone lost", "t,x\n2026-05-03T00:00Z,1\n2026-05-03T01:00,2\n2026-05-03T02:00Z,3\n", "t",
     "has a time zone where the first has none",
     None, None),
    ("cut off", "t [s],x,y\n0,1,2\n1,2,3\n2,3", "t",
     "line 4: found 2 fields, but the header names 3 columns (if it was cut off, delete it)",
     None, None),
]  # fmt: skip
