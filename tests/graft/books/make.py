"""Makes the hard books of the tests of --into: XlsxWriter 3.2 for h1 to h3, h5 by hand.

    python3 make.py && soffice --headless --convert-to xlsx:"Calc MS Excel 2007 XML" --outdir lo h1.xlsx && mv lo/h1.xlsx h4.xlsx

openpyxl.xlsx: h3 with the form and the results of `pipe-insert` in it, loaded and saved by openpyxl 3.1.

h1: charts, images, header image, background, comments, data bars, icon sets, validation, table, sparkline, protection, dynamic
array, chart sheet, hidden and very hidden sheets, names, custom properties. h2: the same with macros and a button. h3: pivot
table with its cache, external link, custom XML, printer settings, order of calculation, slicer. h4: h1 as LibreOffice saves it. h5:
prefixes, odd places and names of parts, decoys, no addresses, defaults for content types, another number format 0, stored entries, a list part that is last.
"""

import io
import struct
import zipfile
import zlib
from datetime import datetime

import xlsxwriter

WHEN = datetime(2024, 1, 1)


def picture(red):
    """A picture of 8 by 8 points."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    rows = b"".join(b"\0" + bytes([red, 80, 160]) * 8 for _ in range(8))
    head = struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def everything(path, macros):
    book = xlsxwriter.Workbook(path)
    book.set_properties({"title": "Impulsor", "author": "Ana", "created": WHEN})
    book.set_custom_property("Order", "R-17")
    bold = book.add_format({"bold": True, "num_format": "0.0000", "bg_color": "#FFEECC", "border": 1})
    sheet = book.add_worksheet("Mis notas")
    for row in range(10):
        sheet.write_number(row, 0, row * 1.5, bold)
        sheet.write_number(row, 1, row * row)
        sheet.write_string(row, 2, f"nota {row} <&>")
    sheet.write_formula("D1", "=SUM(A1:A10)*2", bold, 135)
    sheet.write_dynamic_array_formula("E1:E3", "=SORT(A1:A3)", None, 0)
    sheet.write_rich_string("F1", "one ", bold, "two", " three")
    sheet.write_comment("A1", "mirar esto")
    sheet.conditional_format("A1:A10", {"type": "data_bar", "data_bar_2010": True})
    sheet.conditional_format("B1:B10", {"type": "icon_set", "icon_style": "3_traffic_lights"})
    sheet.conditional_format("C1:C10", {"type": "text", "criteria": "containing", "value": "3", "format": bold})
    sheet.data_validation("G1", {"validate": "list", "source": ["a", "b"]})
    sheet.add_sparkline("H1", {"range": "'Mis notas'!A1:A10"})
    sheet.insert_image("J1", "cell.png", {"image_data": io.BytesIO(picture(200))})
    sheet.set_header("&L&G", {"image_left": "head.png", "image_data_left": io.BytesIO(picture(90))})
    sheet.set_background(io.BytesIO(picture(30)))
    sheet.print_area("A1:D10")
    sheet.repeat_rows(0)
    chart = book.add_chart({"type": "scatter"})
    chart.add_series({"categories": "='Mis notas'!$A$1:$A$10", "values": "='Mis notas'!$B$1:$B$10"})
    sheet.insert_chart("L2", chart)
    table = book.add_worksheet("annex 1")
    table.add_table("B2:C6", {"data": [["x", 1], ["y", 2], ["z", 3], ["w", 4]], "name": "Piezas"})
    table.protect("secret", {"insert_rows": True})
    page = book.add_chartsheet("Hoja de gráfico")
    other = book.add_chart({"type": "line"})
    other.add_series({"values": "='Mis notas'!$B$1:$B$10"})
    page.set_chart(other)
    book.add_worksheet("Oculta").hide()
    hidden = book.add_worksheet("DATA")
    hidden.write("A1", "own figures, not a form")
    hidden.very_hidden()
    book.add_worksheet("It's & 'all' else").write("A1", 1)
    book.define_name("own_name", "='Mis notas'!$A$1")
    book.define_name("'Mis notas'!local_name", "='Mis notas'!$A$2")
    book.define_name("zz_top", "=3.5")
    if macros:
        # A box of the right kind; no macro is in it.
        book.add_vba_project(io.BytesIO(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(range(256)) * 6), True)
        sheet.insert_button("L20", {"macro": "copy_to_incr", "caption": "INCR"})
    book.close()


def fixed(path):
    """Every entry of the same date, so that the same script makes the same bytes."""
    with zipfile.ZipFile(path) as old:
        entries = [(info.filename, old.read(info)) for info in old.infolist()]
    write(path, entries)


class Pipe:
    """What cannot be written twice at one place: sizes then stand behind each entry."""

    def __init__(self, path):
        self.file = open(path, "wb")

    def write(self, data):
        return self.file.write(data)

    def flush(self):
        self.file.flush()


def write(path, entries, stored=(), pipe=False):
    with zipfile.ZipFile(Pipe(path) if pipe else path, "w", zipfile.ZIP_DEFLATED) as new:
        for name, data in entries:
            info = zipfile.ZipInfo(name, (2024, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_STORED if name in stored else zipfile.ZIP_DEFLATED
            new.writestr(info, data)


def pivot(path):
    """A book with parts that rodete never writes."""
    book = xlsxwriter.Workbook(path)
    book.set_properties({"created": WHEN})
    sheet = book.add_worksheet("Source")
    sheet.write_row("A1", ["Tool", "Time"])
    for row, (tool, time) in enumerate([("T1", 3), ("T2", 5), ("T1", 7)], 1):
        sheet.write_row(row, 0, [tool, time])
    sheet.write_formula("D1", "=B2*2", None, 6)
    book.add_worksheet("Pivot").write("A3", "Tool")
    book.close()
    with zipfile.ZipFile(path) as old:
        parts = {info.filename: old.read(info).decode() for info in old.infolist()}
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    rel = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006/relationships"
    head = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\r\n'

    def rels(*all):
        lines = "".join(f'<Relationship Id="{i}" Type="{t}" Target="{to}"{more}/>' for i, t, to, more in all)
        return f'{head}<Relationships xmlns="{package}">{lines}</Relationships>'

    items = '<sharedItems count="2"><s v="T1"/><s v="T2"/></sharedItems>'
    numbers = '<sharedItems containsSemiMixedTypes="0" containsString="0" containsNumber="1" containsInteger="1" minValue="3" maxValue="7"/>'
    parts["xl/pivotCache/pivotCacheDefinition1.xml"] = (
        f'{head}<pivotCacheDefinition xmlns="{main}" xmlns:r="{rel}" r:id="rId1" refreshedBy="Ana" refreshedDate="45000" createdVersion="6" refreshedVersion="6" '
        'minRefreshableVersion="3" recordCount="3"><cacheSource type="worksheet"><worksheetSource ref="A1:B4" sheet="Source"/></cacheSource>'
        f'<cacheFields count="2"><cacheField name="Tool" numFmtId="0">{items}</cacheField><cacheField name="Time" numFmtId="0">{numbers}</cacheField></cacheFields></pivotCacheDefinition>')
    records = "".join(f'<r><x v="{t}"/><n v="{n}"/></r>' for t, n in [(0, 3), (1, 5), (0, 7)])
    parts["xl/pivotCache/pivotCacheRecords1.xml"] = f'{head}<pivotCacheRecords xmlns="{main}" count="3">{records}</pivotCacheRecords>'
    parts["xl/pivotCache/_rels/pivotCacheDefinition1.xml.rels"] = rels(("rId1", f"{rel}/pivotCacheRecords", "pivotCacheRecords1.xml", ""))
    parts["xl/pivotTables/pivotTable1.xml"] = (
        f'{head}<pivotTableDefinition xmlns="{main}" name="Times" cacheId="7" dataCaption="Values" updatedVersion="6" minRefreshableVersion="3" createdVersion="6" outline="1" outlineData="1">'
        '<location ref="A3:B6" firstHeaderRow="1" firstDataRow="1" firstDataCol="1"/><pivotFields count="2"><pivotField axis="axisRow" showAll="0"><items count="3"><item x="0"/><item x="1"/>'
        '<item t="default"/></items></pivotField><pivotField dataField="1" showAll="0"/></pivotFields><rowFields count="1"><field x="0"/></rowFields><rowItems count="3"><i><x/></i><i><x v="1"/></i>'
        '<i t="grand"><x/></i></rowItems><colItems count="1"><i/></colItems><dataFields count="1"><dataField name="Sum of Time" fld="1" baseField="0" baseItem="0"/></dataFields></pivotTableDefinition>')
    parts["xl/pivotTables/_rels/pivotTable1.xml.rels"] = rels(("rId1", f"{rel}/pivotCacheDefinition", "../pivotCache/pivotCacheDefinition1.xml", ""))
    parts["xl/worksheets/_rels/sheet2.xml.rels"] = rels(
        ("rId1", f"{rel}/pivotTable", "../pivotTables/pivotTable1.xml", ""),
        ("rId2", f"{rel}/printerSettings", "../printerSettings/printerSettings1.bin", ""))
    parts["xl/printerSettings/printerSettings1.bin"] = "\0P\0D\0F" * 20
    parts["xl/externalLinks/externalLink1.xml"] = (
        f'{head}<externalLink xmlns="{main}" xmlns:r="{rel}"><externalBook r:id="rId1"><sheetNames><sheetName val="Prices"/></sheetNames>'
        '<sheetDataSet><sheetData sheetId="0"><row r="1"><cell r="A1"><v>12.5</v></cell></row></sheetData></sheetDataSet></externalBook></externalLink>')
    parts["xl/externalLinks/_rels/externalLink1.xml.rels"] = rels(("rId1", f"{rel}/externalLinkPath", "prices.xlsx", ' TargetMode="External"'))
    parts["xl/calcChain.xml"] = f'{head}<calcChain xmlns="{main}"><c r="D1" i="1"/></calcChain>'
    parts["customXml/item1.xml"] = "<order xmlns='urn:shop'>R-17</order>"
    parts["customXml/itemProps1.xml"] = (
        '<ds:datastoreItem xmlns:ds="http://schemas.openxmlformats.org/officeDocument/2006/customXml" ds:itemID="{6A2B1F00-0000-4000-8000-000000000017}"/>')
    parts["customXml/_rels/item1.xml.rels"] = rels(("rId1", f"{rel}/customXmlProps", "itemProps1.xml", ""))
    slicer = "http://schemas.microsoft.com/office/2007/relationships/slicerCache"
    x14 = "http://schemas.microsoft.com/office/spreadsheetml/2009/9/main"
    parts["xl/slicerCaches/slicerCache1.xml"] = (
        f'{head}<slicerCacheDefinition xmlns="{x14}" name="Slicer_Tool" sourceName="Tool"><pivotTables><pivotTable tabId="2" name="Times"/></pivotTables>'
        '<data><tabular pivotCacheId="7"><items count="2"><i x="0" s="1"/><i x="1" s="1"/></items></tabular></data></slicerCacheDefinition>')
    links = parts["xl/_rels/workbook.xml.rels"]
    new = [("rId91", f"{rel}/pivotCacheDefinition", "pivotCache/pivotCacheDefinition1.xml"), ("rId92", f"{rel}/externalLink", "externalLinks/externalLink1.xml"),
           ("rId93", f"{rel}/calcChain", "calcChain.xml"), ("rId94", f"{rel}/customXml", "../customXml/item1.xml"), ("rId95", slicer, "slicerCaches/slicerCache1.xml")]
    lines = "".join(f'<Relationship Id="{i}" Type="{t}" Target="{to}"/>' for i, t, to in new)
    parts["xl/_rels/workbook.xml.rels"] = links.replace("</Relationships>", lines + "</Relationships>")
    text = parts["xl/workbook.xml"]
    text = text.replace("</sheets>", '</sheets><externalReferences><externalReference r:id="rId92"/></externalReferences><definedNames><definedName name="price">[1]Prices!$A$1</definedName></definedNames>')
    text = text.replace("</workbook>", '<pivotCaches><pivotCache cacheId="7" r:id="rId91"/></pivotCaches><extLst><ext uri="{BBE1A952-AA13-448e-AADC-164F8A28A991}" '
                        f'xmlns:x14="{x14}"><x14:slicerCaches><x14:slicerCache r:id="rId95"/></x14:slicerCaches></ext></extLst></workbook>')
    parts["xl/workbook.xml"] = text
    sheet = "application/vnd.openxmlformats-officedocument.spreadsheetml."
    types = [("/xl/pivotCache/pivotCacheDefinition1.xml", f"{sheet}pivotCacheDefinition+xml"), ("/xl/pivotCache/pivotCacheRecords1.xml", f"{sheet}pivotCacheRecords+xml"),
             ("/xl/pivotTables/pivotTable1.xml", f"{sheet}pivotTable+xml"), ("/xl/externalLinks/externalLink1.xml", f"{sheet}externalLink+xml"), ("/xl/calcChain.xml", f"{sheet}calcChain+xml"),
             ("/customXml/itemProps1.xml", "application/vnd.openxmlformats-officedocument.customXmlProperties+xml"), ("/xl/slicerCaches/slicerCache1.xml", "application/vnd.ms-excel.slicerCache+xml")]
    lines = '<Default Extension="bin" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.printerSettings"/>'
    lines += "".join(f'<Override PartName="{p}" ContentType="{t}"/>' for p, t in types)
    parts["[Content_Types].xml"] = parts["[Content_Types].xml"].replace("</Types>", lines + "</Types>")
    write(path, parts.items())


def hostile(path):
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    rel = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    sheet = "application/vnd.openxmlformats-officedocument.spreadsheetml."
    rows = ("<x:row><x:c t='inlineStr'><x:is><x:t>own</x:t></x:is></x:c><x:c><x:v>2.5</x:v></x:c></x:row>"
            "<x:row><x:c><x:f>SUM(B1)*2</x:f><x:v>5</x:v></x:c></x:row>")
    one = f"<?xml version='1.0'?>\n<x:worksheet xmlns:x='{main}'><x:sheetData>{rows}</x:sheetData></x:worksheet>"
    big = "<x:font><x:b/><x:sz val='20'/><x:color theme='4'/><x:name val='Cambria'/><x:scheme val='major'/></x:font>"
    entries = [
        ("_rels/.rels", f"<r:Relationships xmlns:r='{package}/relationships'><r:Relationship Id='a' Type='{rel}/officeDocument' Target='/Book/main.part'/></r:Relationships>"),
        ("Book/_rels/main.part.rels",
         f"<r:Relationships xmlns:r='{package}/relationships'><!-- </r:Relationships> --><r:Relationship Target='../Book/./s/one.part' Id='rId1' Type='{rel}/worksheet'/>"
         f"<r:Relationship Target='s/../s/two.xml' Id='rId3' Type='{rel}/worksheet'/><r:Relationship Target='st%20yles.xml' Id='rId4' Type='{rel}/styles'/></r:Relationships>"),
        ("Book/main.part",
         f"<?xml version='1.0' encoding='UTF-8'?>\n<x:workbook xmlns:x='{main}' xmlns:q='{rel}'><!-- <x:sheets></x:sheets> --><x:bookViews><x:workbookView activeTab='1'/></x:bookViews>"
         "<x:sheets><x:sheet name='annex 1' sheetId='65533' q:id='rId1'/><x:sheet q:id='rId3' sheetId='4' name='A &amp; B'/></x:sheets>"
         "<x:definedNames><x:definedName name='says'>\"&lt;/x:sheets&gt;\"</x:definedName></x:definedNames><x:calcPr calcId='0'/></x:workbook>"),
        ("Book/s/one.part", one),
        ("Book/s/two.xml", one.replace("own", "two")),
        ("Book/st%20yles.xml",
         f"<x:styleSheet xmlns:x='{main}'><x:numFmts count='2'><x:numFmt numFmtId='0' formatCode='dd/mm/yyyy'/><x:numFmt numFmtId='170' formatCode='0.0\" mm\"'/></x:numFmts><x:fonts>{big}</x:fonts><x:fills count='2'><x:fill><x:patternFill patternType='none'/></x:fill>"
         "<x:fill><x:patternFill patternType='gray125'/></x:fill></x:fills><x:borders count='1'><x:border/></x:borders><x:cellStyleXfs count='1'><x:xf/></x:cellStyleXfs>"
         "<x:cellXfs count='2'><x:xf fontId='0' applyFont='1'/><x:xf numFmtId='170' applyNumberFormat='1'/></x:cellXfs><x:dxfs count='0'/></x:styleSheet>"),
        ("[Content_Types].xml",
         f"<t:Types xmlns:t='{package}/content-types'><t:Default Extension='RELS' ContentType='application/vnd.openxmlformats-package.relationships+xml'/>"
         f"<t:Default Extension='xml' ContentType='{sheet}worksheet+xml'/><t:Default Extension='part' ContentType='{sheet}worksheet+xml'/>"
         f"<t:Override PartName='/Book/main.part' ContentType='{sheet}sheet.main+xml'/><t:Override PartName='/BOOK/st%20yles.xml' ContentType='{sheet}styles+xml'/></t:Types>"),
    ]
    write(path, entries, stored=("Book/main.part", "Book/s/one.part"), pipe=True)


everything("h1.xlsx", False)
fixed("h1.xlsx")
everything("h2.xlsm", True)
fixed("h2.xlsm")
pivot("h3.xlsx")
hostile("h5.xlsx")
