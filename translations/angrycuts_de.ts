<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_US">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Verzeichnis</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Laufwerk</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Symbolischer Link</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>&amp;Inkrementieren</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>&amp;Dekrementieren</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>Unbekannte Option „%1“.</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>Unbekannte Optionen: %1.</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>Nach „%1“ fehlt der Wert.</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>Unerwarteter Wert nach „%1“.</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Verzeichnis:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateien des Typs:</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Verzeichnis suchen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordnetes Verzeichnis</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Gehe zum übergeordneten Verzeichnis</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuen Ordner erstellen</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Neuen Ordner erstellen</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Neues Verzeichnis</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Neues Verzeichnis</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Wechsle zu Listenansicht</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Wechsle zu Detailansicht</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Seitenleiste</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Liste der Orte und Lesezeichen</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Verzeichnisse</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Zuletzt besucht</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Speichern unter</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Anzeigen </translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>&amp;Versteckte Dateien anzeigen</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>Die Datei %1 existiert bereits.
Soll sie überschrieben werden?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>&apos;%1&apos; ist schreibgeschützt.
Möchten Sie die Datei trotzdem löschen?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>Sind Sie sicher, dass Sie &apos;%1&apos; löschen möchten?</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>Das Verzeichnis konnte nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Die Datei konnte nicht gefunden werden.
Stellen Sie sicher, dass der Dateiname richtig ist.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Das Verzeichnis konnte nicht gefunden werden.
Stellen Sie sicher, dass der Verzeichnisname richtig ist.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Änderungsdatum</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Computer</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mein Computer</translation>
    </message>
</context>
<context>
    <name>QGnomeTheme</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Schl&amp;ießen</translation>
    </message>
    <message>
        <source>Close without Saving</source>
        <translation>Schließen ohne zu Speichern</translation>
    </message>
</context>
<context>
    <name>QIODevice</name>
    <message>
        <source>Permission denied</source>
        <translation>Zugriff verweigert</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele offene Dateien</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>file to open is a directory</source>
        <translation>das ist ein Ordner, keine Datei</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wieder&amp;herstellen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Einf&amp;ügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>Details einblenden...</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Details ausblenden...</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Ja, &amp;alle</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;ein, keine</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Alles speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorieren</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>QSaveFile</name>
    <message>
        <source>Existing file %1 is not writable</source>
        <translation>Die vorhandene Datei %1 ist schreibgeschützt</translation>
    </message>
    <message>
        <source>Filename refers to a directory</source>
        <translation>Der Name gehört zu einem Ordner</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Hierher scrollen</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Linker Rand</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Rechter Rand</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Eine Seite nach links</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Eine Seite nach oben</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Eine Seite nach rechts</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Eine Seite nach unten</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Nach links scrollen</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Nach oben scrollen</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Nach rechts scrollen</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Nach unten scrollen</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umsch</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Herunter</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild aufwärts</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild abwärts</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Bild aufwärts</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Bild abwärts</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Escape</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backtab</source>
        <translation>Rück-Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Return</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Media Play</source>
        <translation>Wiedergabe</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Nach links scrollen</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Nach rechts scrollen</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Wieder&amp;herstellen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>&amp;Link-Adresse kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Einf&amp;ügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>app::Arguments</name>
    <message>
        <source>stands twice</source>
        <translation>kommt zweimal vor</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>unerwartetes Argument „%1“</translation>
    </message>
    <message>
        <source>must be a number, got &quot;%1&quot;</source>
        <translation>muss eine Zahl sein, ist aber „%1“</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>muss ein Name sein</translation>
    </message>
</context>
<context>
    <name>app::CsvOutput</name>
    <message>
        <source>standard output</source>
        <translation>Standardausgabe</translation>
    </message>
</context>
<context>
    <name>app::Demonstration</name>
    <message>
        <source>every method diverged before %1 s</source>
        <translation>alle Verfahren divergierten vor %1 s</translation>
    </message>
    <message>
        <source>There is no display for the window, so &quot;%1&quot; was simulated for %2 s.
%3: energy with %4
%5: where every weight is, with %6
%7: the scene at %8 s
</source>
        <translation>Es gibt keinen Bildschirm für das Fenster, daher wurde „%1“ %2 s lang simuliert.
%3: Energie mit %4
%5: wo jedes Gewicht ist, mit %6
%7: die Szene bei %8 s
</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
</context>
<context>
    <name>app::EnergyHistory</name>
    <message>
        <source>Time in s; energies in J: kinetic, potential, lost to air, to impacts, to ropes, to friction; numerical drift
</source>
        <translation>Zeit in s; Energien in J: kinetisch, potentiell, Verlust durch Luft, Stöße, Seile, Reibung; numerische Drift
</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentiell</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>impacts</source>
        <translation>Stöße</translation>
    </message>
    <message>
        <source>ropes</source>
        <translation>Seile</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>Drift</translation>
    </message>
</context>
<context>
    <name>app::ExitStatus</name>
    <message>
        <source>standard output: %1</source>
        <translation>Standardausgabe: %1</translation>
    </message>
</context>
<context>
    <name>app::HelpText</name>
    <message>
        <source>Usage:
  angrycuts [SCENE]                     open the window
  angrycuts scenes [--export FOLDER]    list the built-in scenes, or write them as files
  angrycuts simulate SCENE [options]    run without a window
  angrycuts measure SCENE [options]     measure speed against accuracy
  angrycuts --help, --version

A SCENE is a file or the name of a built-in scene. Where there is no display,
angrycuts [SCENE] simulates the scene with each of its methods and writes what they
gave into the current folder.

Options of simulate:
  --method NAME        %1 (rk4)
  --step SECONDS       step of the method, from 1e-7 to 10 (1/60)
  --tolerance X        instead of a step for dopri5, from 1e-14 to 1 (1e-9)
  --until SECONDS      simulated time to reach, from 0 to 1e6 (10)
  --cut SECONDS|never  when all ropes are cut (as the scene says)
  --sample SECONDS     time between rows, from 1e-7 to 1e6 (0.1)
  --trajectory FILE    where every weight is, as CSV; - is standard output
  --energy FILE        where the energy is, as CSV; - is standard output
  --events FILE        what happened, as CSV; - is standard output
  --chart FILE         the energy chart as .png, .svg or .pdf
With none of the four files it prints a short table.

Options of measure, which tries all methods at many steps:
  --until SECONDS      simulated time to measure over, from 0 to 1e6 (10)
  --cut SECONDS|never  when all ropes are cut (as the scene says)
  --csv FILE           all figures, as CSV; - is standard output
  --chart FILE         error against cost as .png, .svg or .pdf
With neither file it prints a short table.

Exit status: 0; 2 where the call or the scene is refused; 3 where the numbers,
or the events or steps within one step, got out of hand; 1 for anything else,
such as a full disk.
</source>
        <translation>Aufruf:
  angrycuts [SZENE]                     öffnet das Fenster
  angrycuts scenes [--export ORDNER]    listet die eingebauten Szenen oder schreibt sie als Dateien
  angrycuts simulate SZENE [Optionen]   rechnet ohne Fenster
  angrycuts measure SZENE [Optionen]    misst Rechenzeit gegen Genauigkeit
  angrycuts --help, --version

Eine SZENE ist eine Datei oder der Name einer eingebauten Szene. Ohne Bildschirm
simuliert angrycuts [SZENE] die Szene mit jedem ihrer Verfahren und schreibt die
Ergebnisse in den aktuellen Ordner.

Optionen von simulate:
  --method NAME          %1 (rk4)
  --step SEKUNDEN        Schrittweite des Verfahrens, von 1e-7 bis 10 (1/60)
  --tolerance X          statt einer Schrittweite für dopri5, von 1e-14 bis 1 (1e-9)
  --until SEKUNDEN       simulierte Zeit bis zum Ende, von 0 bis 1e6 (10)
  --cut SEKUNDEN|never   wann alle Seile durchgeschnitten werden (wie in der Szene)
  --sample SEKUNDEN      Zeit zwischen den Zeilen, von 1e-7 bis 1e6 (0.1)
  --trajectory DATEI     wo jedes Gewicht ist, als CSV; - ist die Standardausgabe
  --energy DATEI         wo die Energie ist, als CSV; - ist die Standardausgabe
  --events DATEI         was geschah, als CSV; - ist die Standardausgabe
  --chart DATEI          das Energiediagramm als .png, .svg oder .pdf
Ohne eine der vier Dateien wird eine kurze Tabelle ausgegeben.

Optionen von measure, das alle Verfahren mit vielen Schrittweiten prüft:
  --until SEKUNDEN       simulierte Zeit, über die gemessen wird, von 0 bis 1e6 (10)
  --cut SEKUNDEN|never   wann alle Seile durchgeschnitten werden (wie in der Szene)
  --csv DATEI            alle Zahlen, als CSV; - ist die Standardausgabe
  --chart DATEI          Fehler gegen Aufwand als .png, .svg oder .pdf
Ohne eine dieser Dateien wird eine kurze Tabelle ausgegeben.

Rückgabewert: 0; 2, wo Aufruf oder Szene abgelehnt werden; 3, wo die Zahlen, oder die
Ereignisse oder Schritte in einem Schritt, außer Kontrolle gerieten; 1 für alles andere,
etwa einen vollen Datenträger.
</translation>
    </message>
</context>
<context>
    <name>app::MeasureTable</name>
    <message>
        <source>at most</source>
        <translation>höchstens</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <translation>extrapoliert</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>least error</source>
        <translation>min. Fehler</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>ns per s</source>
        <translation>ns pro s</translation>
    </message>
    <message>
        <source>Order: the power of the step that the position error falls with. Setting (step in s, or tolerance)
and cost (ns of computing per simulated second): to be right within 1e-6 m.

</source>
        <translation>Ordnung: die Potenz der Schrittweite, mit der der Ortsfehler fällt. Einstellung (Schrittweite in s
oder Toleranz) und Aufwand (ns Rechenzeit pro simulierter Sekunde): für einen Fehler bis 1e-6 m.

</translation>
    </message>
</context>
<context>
    <name>app::Options</name>
    <message>
        <source>%1 is used twice</source>
        <translation>%1 wird zweimal verwendet</translation>
    </message>
    <message>
        <source>must end in .png, .svg or .pdf, got &quot;%1&quot;</source>
        <translation>muss auf .png, .svg oder .pdf enden, ist aber „%1“</translation>
    </message>
    <message>
        <source>%1: a scene must be named</source>
        <translation>%1: Es muss eine Szene angegeben werden</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;</source>
        <translation>unbekannter Befehl „%1“</translation>
    </message>
    <message>
        <source>must be one of %1, got &quot;%2&quot;</source>
        <translation>muss eines von %1 sein, ist aber „%2“</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 nimmt eine Toleranz, keine Schrittweite</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 nimmt eine Schrittweite, keine Toleranz</translation>
    </message>
</context>
<context>
    <name>app::ProgressLine</name>
    <message>
        <source>Measuring: %1 %</source>
        <translation>Messung: %1 %</translation>
    </message>
</context>
<context>
    <name>app::ScenesCommand</name>
    <message>
        <source>%1: the folder cannot be made</source>
        <translation>%1: Der Ordner kann nicht angelegt werden</translation>
    </message>
</context>
<context>
    <name>app::SimulateCommand</name>
    <message>
        <source>a larger --tolerance may help</source>
        <translation>ein größeres --tolerance kann helfen</translation>
    </message>
    <message>
        <source>a smaller --tolerance may help</source>
        <translation>ein kleineres --tolerance kann helfen</translation>
    </message>
    <message>
        <source>a smaller --step may help</source>
        <translation>ein kleineres --step kann helfen</translation>
    </message>
    <message>
        <source>--step %1 works</source>
        <translation>--step %1 funktioniert</translation>
    </message>
    <message>
        <source>the numbers stopped being finite</source>
        <translation>die Zahlen sind nicht mehr endlich</translation>
    </message>
    <message>
        <source>the next step holds more events than can be followed</source>
        <translation>der nächste Schritt hat mehr Ereignisse, als verfolgt werden können</translation>
    </message>
    <message>
        <source>the tolerance asks for more or smaller steps than can be taken</source>
        <translation>die Toleranz verlangt mehr oder kleinere Schritte, als möglich sind</translation>
    </message>
    <message>
        <source>diverged at %1 s: %2; %3</source>
        <translation>divergiert bei %1 s: %2; %3</translation>
    </message>
</context>
<context>
    <name>app::main</name>
    <message>
        <source>the window cannot be opened: %1</source>
        <translation>das Fenster kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>no display answers (%1)</source>
        <translation>kein Bildschirm antwortet (%1)</translation>
    </message>
</context>
<context>
    <name>ui::AccuracyPanel</name>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>Error against cost</source>
        <translation>Fehler gegen Aufwand</translation>
    </message>
    <message>
        <source>Error against step</source>
        <translation>Fehler gegen Schrittweite</translation>
    </message>
    <message>
        <source>What the chart shows</source>
        <translation>Was das Diagramm zeigt</translation>
    </message>
    <message>
        <source>Right within</source>
        <translation>Fehler bis</translation>
    </message>
    <message>
        <source>Error against cost or step</source>
        <translation>Fehler gegen Aufwand oder Schrittweite</translation>
    </message>
    <message>
        <source>Click a point to open it as a run</source>
        <translation>Klicken Sie auf einen Punkt, um ihn als Lauf zu öffnen</translation>
    </message>
    <message>
        <source>Measures every method at steps from 1/8 to 1/8192 s: how far the weights are from where they really are, and what that costs. Takes some seconds.</source>
        <translation>Misst jedes Verfahren bei Schrittweiten von 1/8 bis 1/8192 s: wie weit die Gewichte von ihrem wahren Ort entfernt sind und was das kostet. Dauert einige Sekunden.</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>genauigkeit</translation>
    </message>
    <message>
        <source>How long each run is followed, in s; errors are compared at its end</source>
        <translation>Wie lange jeder Lauf verfolgt wird, in s; am Ende werden die Fehler verglichen</translation>
    </message>
    <message>
        <source>Cost is counted in slope evaluations, which the time of computing goes with</source>
        <translation>Der Aufwand zählt in Steigungsberechnungen, denen die Rechenzeit folgt</translation>
    </message>
    <message>
        <source>Largest distance from the true place that is accepted, in m: which method reaches it at the lowest cost?</source>
        <translation>Größter Abstand vom wahren Ort, der zugelassen wird, in m: Welches Verfahren erreicht ihn mit dem kleinsten Aufwand?</translation>
    </message>
</context>
<context>
    <name>ui::BuiltInScenes</name>
    <message>
        <source>no file or built-in scene of that name</source>
        <translation>keine Datei oder eingebaute Szene dieses Namens</translation>
    </message>
</context>
<context>
    <name>ui::ChartFile</name>
    <message>
        <source>a chart&apos;s file ends in .png, .svg or .pdf</source>
        <translation>die Datei eines Diagramms endet auf .png, .svg oder .pdf</translation>
    </message>
</context>
<context>
    <name>ui::ChartKind</name>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Energies over time</source>
        <translation>Energien über der Zeit</translation>
    </message>
    <message>
        <source>Ledger</source>
        <translation>Bilanz</translation>
    </message>
    <message>
        <source>Where the energy is and went, stacked</source>
        <translation>Energiebilanz: wo die Energie ist und wohin sie ging, gestapelt</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Phase portrait: angular velocity against angle</source>
        <translation>Phasenporträt: Winkelgeschwindigkeit gegen Winkel</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Paths of the weights: y against x</source>
        <translation>Bahnen der Gewichte: y gegen x</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height above the floor over time</source>
        <translation>Höhe über dem Boden über der Zeit</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed over time</source>
        <translation>Tempo über der Zeit</translation>
    </message>
</context>
<context>
    <name>ui::ChartOverlay</name>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
</context>
<context>
    <name>ui::ChartReadings</name>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>ui::ChartScales</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>ui::ChartSizeDialog</name>
    <message>
        <source>Page width</source>
        <translation>Seitenbreite</translation>
    </message>
    <message>
        <source>Half the page width</source>
        <translation>Halbe Seitenbreite</translation>
    </message>
    <message>
        <source>Slide, 16:9</source>
        <translation>Folie, 16:9</translation>
    </message>
    <message>
        <source>Poster, A3</source>
        <translation>Poster, A3</translation>
    </message>
    <message>
        <source>Size of the chart</source>
        <translation>Größe des Diagramms</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Eigene Größe</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Für</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>Sizes that are often wanted</source>
        <translation>Größen, die oft gebraucht werden</translation>
    </message>
    <message>
        <source>Width of the chart on paper, in mm</source>
        <translation>Breite des Diagramms auf Papier, in mm</translation>
    </message>
    <message>
        <source>Height of the chart on paper, in mm</source>
        <translation>Höhe des Diagramms auf Papier, in mm</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Zweck</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>ui::ChartTable</name>
    <message>
        <source>%1 (%2), %3</source>
        <translation>%1 (%2), %3</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>ui::ChartWidget</name>
    <message>
        <source>A click goes to a moment. Wheel, plus and minus zoom, dragging a box does, too; Alt and the arrow keys move the chart, 0 shows all of it.</source>
        <translation>Ein Klick geht zu einem Zeitpunkt. Rad, Plus und Minus vergrößern, ein gezogener Rahmen auch; Alt und die Pfeiltasten verschieben das Diagramm, 0 zeigt alles.</translation>
    </message>
</context>
<context>
    <name>ui::ChartsPanel</name>
    <message>
        <source>Kind of chart</source>
        <translation>Art des Diagramms</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Alle Gewichte</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Gewicht </translation>
    </message>
    <message>
        <source>Weight in the chart</source>
        <translation>Gewicht im Diagramm</translation>
    </message>
    <message>
        <source>Weight in the chart, counted from the left; 0: all</source>
        <translation>Gewicht im Diagramm, von links gezählt; 0: alle</translation>
    </message>
    <message>
        <source>Runs in the chart</source>
        <translation>Läufe im Diagramm</translation>
    </message>
    <message>
        <source>Chart menu</source>
        <translation>Diagramm-Menü</translation>
    </message>
    <message>
        <source>Zoom, copy, export, hide curves</source>
        <translation>Zoomen, kopieren, exportieren, Kurven ausblenden</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>K&amp;urven</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Alle Läufe</translation>
    </message>
    <message>
        <source>What the chart shows against what</source>
        <translation>Was das Diagramm gegen was zeigt</translation>
    </message>
</context>
<context>
    <name>ui::Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Start with one weight in an empty room</source>
        <translation>Mit einem Gewicht in einem leeren Raum beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>Eine Szenendatei öffnen</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Lektionen…</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Choose one of the built-in scenes by its picture</source>
        <translation>Eine der eingebauten Szenen nach ihrem Bild auswählen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Die Szene speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save the scene in another file</source>
        <translation>Die Szene in einer anderen Datei speichern</translation>
    </message>
    <message>
        <source>&amp;Export chart…</source>
        <translation>&amp;Diagramm exportieren…</translation>
    </message>
    <message>
        <source>Save the chart as a PNG, SVG or PDF picture</source>
        <translation>Das Diagramm als PNG-, SVG- oder PDF-Bild speichern</translation>
    </message>
    <message>
        <source>Export &amp;picture of the scene…</source>
        <translation>B&amp;ild der Szene exportieren…</translation>
    </message>
    <message>
        <source>Save what is shown as a PNG, SVG or PDF picture</source>
        <translation>Das Gezeigte als PNG-, SVG- oder PDF-Bild speichern</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change of the scene</source>
        <translation>Die letzte Änderung der Szene zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make the change again that was taken back last</source>
        <translation>Die zuletzt zurückgenommene Änderung wiederholen</translation>
    </message>
    <message>
        <source>&amp;Weights table</source>
        <translation>&amp;Gewichtetabelle</translation>
    </message>
    <message>
        <source>All weights in a table, to be changed many at once</source>
        <translation>Alle Gewichte in einer Tabelle, um viele auf einmal zu ändern</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Let time pass, or stop it</source>
        <translation>Die Zeit laufen lassen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Take one integration step of the first run</source>
        <translation>Einen Integrationsschritt des ersten Laufs machen</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Schritt &amp;zurück</translation>
    </message>
    <message>
        <source>Go back by one integration step of the first run</source>
        <translation>Um einen Integrationsschritt des ersten Laufs zurückgehen</translation>
    </message>
    <message>
        <source>Step one &amp;frame</source>
        <translation>Ein &amp;Bild weiter</translation>
    </message>
    <message>
        <source>Go on by 1/60 s, times the speed</source>
        <translation>Um 1/60 s mal Ablauftempo weitergehen</translation>
    </message>
    <message>
        <source>Step a f&amp;rame back</source>
        <translation>Ein Bild z&amp;urück</translation>
    </message>
    <message>
        <source>Go back by 1/60 s, times the speed</source>
        <translation>Um 1/60 s mal Ablauftempo zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Cut the ropes</source>
        <translation>Seile &amp;durchschneiden</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cut all ropes now</source>
        <translation>Jetzt alle Seile durchschneiden</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Go back to the start</source>
        <translation>Zum Start zurückgehen</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Halve the speed</source>
        <translation>Das Ablauftempo halbieren</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>Sch&amp;neller</translation>
    </message>
    <message>
        <source>Double the speed</source>
        <translation>Das Ablauftempo verdoppeln</translation>
    </message>
    <message>
        <source>Split &amp;views</source>
        <translation>Ansichten &amp;teilen</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Give each run a view of its own</source>
        <translation>Jedem Lauf eine eigene Ansicht geben</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Go to the next event of any kind</source>
        <translation>Zum nächsten Ereignis jeder Art gehen</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>&amp;Voriges Ereignis</translation>
    </message>
    <message>
        <source>Go back to the event before</source>
        <translation>Zum Ereignis davor zurückgehen</translation>
    </message>
    <message>
        <source>Next &amp;impact</source>
        <translation>Nächster &amp;Stoß</translation>
    </message>
    <message>
        <source>Go on until something is hit</source>
        <translation>Weiter, bis etwas getroffen wird</translation>
    </message>
    <message>
        <source>Previous i&amp;mpact</source>
        <translation>Voriger St&amp;oß</translation>
    </message>
    <message>
        <source>Go back to the impact before</source>
        <translation>Zum Stoß davor zurückgehen</translation>
    </message>
    <message>
        <source>Next &amp;turning point</source>
        <translation>Nächster &amp;Umkehrpunkt</translation>
    </message>
    <message>
        <source>Go on until a weight turns round on its rope</source>
        <translation>Weiter, bis ein Gewicht an seinem Seil umkehrt</translation>
    </message>
    <message>
        <source>Previous t&amp;urning point</source>
        <translation>Voriger Um&amp;kehrpunkt</translation>
    </message>
    <message>
        <source>Go back to the turning point before</source>
        <translation>Zum Umkehrpunkt davor zurückgehen</translation>
    </message>
    <message>
        <source>Next &amp;cut</source>
        <translation>Nächster S&amp;chnitt</translation>
    </message>
    <message>
        <source>Go on until ropes are cut</source>
        <translation>Weiter, bis Seile durchgeschnitten werden</translation>
    </message>
    <message>
        <source>Previous cu&amp;t</source>
        <translation>Voriger Sc&amp;hnitt</translation>
    </message>
    <message>
        <source>Go back to the cut before</source>
        <translation>Zum Schnitt davor zurückgehen</translation>
    </message>
    <message>
        <source>&amp;Start of the recording</source>
        <translation>&amp;Anfang der Aufzeichnung</translation>
    </message>
    <message>
        <source>Show the start again; what is recorded stays</source>
        <translation>Wieder den Start zeigen; das Aufgezeichnete bleibt</translation>
    </message>
    <message>
        <source>&amp;End of the recording</source>
        <translation>&amp;Ende der Aufzeichnung</translation>
    </message>
    <message>
        <source>Show the last moment that is computed</source>
        <translation>Den letzten berechneten Zeitpunkt zeigen</translation>
    </message>
    <message>
        <source>&amp;Go to a time…</source>
        <translation>&amp;Gehe zu Zeitpunkt…</translation>
    </message>
    <message>
        <source>Show any moment, and compute it first where needed</source>
        <translation>Einen beliebigen Zeitpunkt zeigen und ihn bei Bedarf zuerst berechnen</translation>
    </message>
    <message>
        <source>Stop &amp;on the way</source>
        <translation>Unter&amp;wegs anhalten</translation>
    </message>
    <message>
        <source>Stay at the moment that the computing has come to</source>
        <translation>Bei dem Zeitpunkt bleiben, den die Rechnung erreicht hat</translation>
    </message>
    <message>
        <source>Speed and &amp;accuracy…</source>
        <translation>Rechenzeit und Genauigkei&amp;t…</translation>
    </message>
    <message>
        <source>Measure what accuracy costs, and how large steps may be</source>
        <translation>Messen, was Genauigkeit kostet und wie groß die Schritte sein dürfen</translation>
    </message>
    <message>
        <source>&amp;When to cut?…</source>
        <translation>&amp;Wann schneiden?…</translation>
    </message>
    <message>
        <source>Find the moments to cut at that hit the target</source>
        <translation>Die Schnittzeiten finden, die das Ziel treffen</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>&amp;Spuren</translation>
    </message>
    <message>
        <source>Show where the weights have just been</source>
        <translation>Zeigen, wo die Gewichte gerade waren</translation>
    </message>
    <message>
        <source>V&amp;elocities</source>
        <translation>&amp;Geschwindigkeiten</translation>
    </message>
    <message>
        <source>Show how fast the weights move, and where to, as arrows</source>
        <translation>Mit Pfeilen zeigen, wie schnell sich die Gewichte bewegen und wohin</translation>
    </message>
    <message>
        <source>Fo&amp;rces</source>
        <translation>&amp;Kräfte</translation>
    </message>
    <message>
        <source>Show gravity, air drag and the pull of the rope as arrows</source>
        <translation>Gewichtskraft, Luftwiderstand und Seilkraft als Pfeile zeigen</translation>
    </message>
    <message>
        <source>Te&amp;nsions</source>
        <translation>S&amp;eilkräfte</translation>
    </message>
    <message>
        <source>Show in newtons how hard each rope pulls</source>
        <translation>In Newton zeigen, wie stark jedes Seil zieht</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Lineal</translation>
    </message>
    <message>
        <source>Measure a length in the scene</source>
        <translation>Eine Länge in der Szene messen</translation>
    </message>
    <message>
        <source>&amp;Protractor</source>
        <translation>&amp;Winkelmesser</translation>
    </message>
    <message>
        <source>Measure an angle in the scene</source>
        <translation>Einen Winkel in der Szene messen</translation>
    </message>
    <message>
        <source>&amp;Stopwatch</source>
        <translation>&amp;Stoppuhr</translation>
    </message>
    <message>
        <source>Measure simulated time</source>
        <translation>Simulierte Zeit messen</translation>
    </message>
    <message>
        <source>S&amp;tart or stop the stopwatch</source>
        <translation>Stoppuhr s&amp;tarten, anhalten</translation>
    </message>
    <message>
        <source>Start the stopwatch at the moment shown, or stop it</source>
        <translation>Die Stoppuhr beim gezeigten Zeitpunkt starten oder anhalten</translation>
    </message>
    <message>
        <source>Stopwatch to &amp;zero</source>
        <translation>Stoppuhr auf N&amp;ull</translation>
    </message>
    <message>
        <source>Set the stopwatch back to zero</source>
        <translation>Die Stoppuhr auf null zurückstellen</translation>
    </message>
    <message>
        <source>&amp;Next handle</source>
        <translation>&amp;Nächster Griff</translation>
    </message>
    <message>
        <source>Choose what Alt and the arrow keys move: an end of the ruler, an arm of the protractor …</source>
        <translation>Wählen, was Alt und die Pfeiltasten bewegen: ein Ende des Lineals, einen Schenkel des Winkelmessers …</translation>
    </message>
    <message>
        <source>Tar&amp;get</source>
        <translation>&amp;Ziel</translation>
    </message>
    <message>
        <source>Show a target on the floor; drag it to where it shall be</source>
        <translation>Ein Ziel auf dem Boden zeigen; ziehen Sie es an seinen Platz</translation>
    </message>
    <message>
        <source>&amp;Lesson text</source>
        <translation>Lekti&amp;onstext</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Show what to look for and what to try, or hide it</source>
        <translation>Zeigen, worauf zu achten und was zu probieren ist, oder ausblenden</translation>
    </message>
    <message>
        <source>&amp;Fit the room</source>
        <translation>&amp;Raum einpassen</translation>
    </message>
    <message>
        <source>Show the whole room</source>
        <translation>Den ganzen Raum zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Vergrößern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Verk&amp;leinern</translation>
    </message>
    <message>
        <source>&amp;Next weight</source>
        <translation>&amp;Nächstes Gewicht</translation>
    </message>
    <message>
        <source>Select the next weight</source>
        <translation>Das nächste Gewicht auswählen</translation>
    </message>
    <message>
        <source>&amp;Previous weight</source>
        <translation>&amp;Voriges Gewicht</translation>
    </message>
    <message>
        <source>Select the weight before</source>
        <translation>Das Gewicht davor auswählen</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>Auswahl auf&amp;heben</translation>
    </message>
    <message>
        <source>Select no weight and no handle any more</source>
        <translation>Kein Gewicht und keinen Griff mehr auswählen</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Nach &amp;links bewegen</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the left, or move the weight or handle</source>
        <translation>Das Seil des ausgewählten Gewichts nach links drehen oder Gewicht oder Griff bewegen</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>Nach &amp;rechts bewegen</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the right, or move the weight or handle</source>
        <translation>Das Seil des ausgewählten Gewichts nach rechts drehen oder Gewicht oder Griff bewegen</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Nach &amp;oben bewegen</translation>
    </message>
    <message>
        <source>Shorten the rope of the selected weight, or move the weight or handle up</source>
        <translation>Das Seil des ausgewählten Gewichts verkürzen oder Gewicht oder Griff nach oben bewegen</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Nach &amp;unten bewegen</translation>
    </message>
    <message>
        <source>Lengthen the rope of the selected weight, or move the weight or handle down</source>
        <translation>Das Seil des ausgewählten Gewichts verlängern oder Gewicht oder Griff nach unten bewegen</translation>
    </message>
    <message>
        <source>Faster l&amp;eft</source>
        <translation>Schneller nach l&amp;inks</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the left</source>
        <translation>Die Geschwindigkeit des ausgewählten Gewichts nach links erhöhen</translation>
    </message>
    <message>
        <source>Faster r&amp;ight</source>
        <translation>Schneller nach r&amp;echts</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the right</source>
        <translation>Die Geschwindigkeit des ausgewählten Gewichts nach rechts erhöhen</translation>
    </message>
    <message>
        <source>&amp;Faster up</source>
        <translation>Schneller nach o&amp;ben</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight upwards</source>
        <translation>Die Geschwindigkeit des ausgewählten Gewichts nach oben erhöhen</translation>
    </message>
    <message>
        <source>Fa&amp;ster down</source>
        <translation>Schneller nach un&amp;ten</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight downwards</source>
        <translation>Die Geschwindigkeit des ausgewählten Gewichts nach unten erhöhen</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>&amp;Präsentieren</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Präsentieren</translation>
    </message>
    <message>
        <source>Fill the screen with the scene and one chart, in large type</source>
        <translation>Den Bildschirm mit der Szene und einem Diagramm füllen, in großer Schrift</translation>
    </message>
    <message>
        <source>&amp;Next chart</source>
        <translation>&amp;Nächstes Diagramm</translation>
    </message>
    <message>
        <source>Show the next kind of chart</source>
        <translation>Die nächste Art von Diagramm zeigen</translation>
    </message>
    <message>
        <source>&amp;Previous chart</source>
        <translation>&amp;Voriges Diagramm</translation>
    </message>
    <message>
        <source>Show the previous kind of chart</source>
        <translation>Die vorige Art von Diagramm zeigen</translation>
    </message>
    <message>
        <source>&amp;Whole chart</source>
        <translation>&amp;Ganzes Diagramm</translation>
    </message>
    <message>
        <source>Show all of the chart again after zooming</source>
        <translation>Nach dem Zoomen wieder das ganze Diagramm zeigen</translation>
    </message>
    <message>
        <source>&amp;Copy chart</source>
        <translation>Diagramm &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the chart as a picture for paper</source>
        <translation>Das Diagramm als Bild für Papier kopieren</translation>
    </message>
    <message>
        <source>Copy chart &amp;data</source>
        <translation>Diagrammd&amp;aten kopieren</translation>
    </message>
    <message>
        <source>Copy the chart&apos;s curves as a table for a spreadsheet</source>
        <translation>Die Kurven des Diagramms als Tabelle für eine Tabellenkalkulation kopieren</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>List all keys</source>
        <translation>Alle Tasten auflisten</translation>
    </message>
    <message>
        <source>&amp;About Angry Cuts</source>
        <translation>&amp;Über Angry Cuts</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>&amp;Teacher&apos;s sheet</source>
        <translation>&amp;Lehrerblatt</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Goal, steps, questions and expected figures of this lesson, to be printed</source>
        <translation>Ziel, Schritte, Fragen und erwartete Zahlen dieser Lektion, zum Ausdrucken</translation>
    </message>
    <message>
        <source>Quick &amp;guide</source>
        <translation>Kurz&amp;anleitung</translation>
    </message>
    <message>
        <source>Explain the window in a few pages</source>
        <translation>Das Fenster auf wenigen Seiten erklären</translation>
    </message>
    <message>
        <source>The &amp;model</source>
        <translation>Das &amp;Modell</translation>
    </message>
    <message>
        <source>Show the equations that are computed, and why</source>
        <translation>Die Gleichungen zeigen, die berechnet werden, und warum</translation>
    </message>
    <message>
        <source>T&amp;our of the window</source>
        <translation>&amp;Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>Point out the five most important parts of the window</source>
        <translation>Die fünf wichtigsten Teile des Fensters zeigen</translation>
    </message>
</context>
<context>
    <name>ui::ComparisonPanel</name>
    <message>
        <source>Run that distances are measured from</source>
        <translation>Lauf, von dem aus Abstände gemessen werden</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Apart (m)</source>
        <translation>Abstand (m)</translation>
    </message>
    <message>
        <source>Drift (J)</source>
        <translation>Drift (J)</translation>
    </message>
    <message>
        <source>Drift (%)</source>
        <translation>Drift (%)</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Steigungen</translation>
    </message>
    <message>
        <source>The same as a share of the energy at the start</source>
        <translation>Dasselbe als Anteil der Energie beim Start</translation>
    </message>
    <message>
        <source>Slope evaluations so far</source>
        <translation>Steigungsberechnungen bisher</translation>
    </message>
    <message>
        <source>Runs in figures</source>
        <translation>Läufe in Zahlen</translation>
    </message>
    <message>
        <source>Distance from %1</source>
        <translation>Abstand von %1</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, now: max |p − p&apos;|, in m</source>
        <translation>Größter Abstand desselben Gewichts in beiden Läufen, jetzt: max |p − p&apos;|, in m</translation>
    </message>
    <message>
        <source>Energy the method got wrong so far, in J: kinetic + potential + losses − energy at the start</source>
        <translation>Energie, die das Verfahren bisher verfälscht hat, in J: kinetische + potentielle + Verluste − Energie am Anfang</translation>
    </message>
    <message>
        <source>Method and step of the run</source>
        <translation>Verfahren und Schritt des Laufs</translation>
    </message>
    <message>
        <source>How far the runs are apart, and what each got wrong, at the moment shown</source>
        <translation>Wie weit die Läufe auseinander sind und was jeder verfälscht hat, zum gezeigten Zeitpunkt</translation>
    </message>
</context>
<context>
    <name>ui::CutQuestions</name>
    <message>
        <source>Cut between</source>
        <translation>Schnitt zwischen</translation>
    </message>
    <message>
        <source>and</source>
        <translation>und</translation>
    </message>
    <message>
        <source>Weight that is to hit the target</source>
        <translation>Gewicht, das das Ziel treffen soll</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Welches Gewicht, von links gezählt</translation>
    </message>
    <message>
        <source>Method that finds the moments</source>
        <translation>Verfahren, das die Zeitpunkte sucht</translation>
    </message>
    <message>
        <source>Center of the target</source>
        <translation>Mitte des Ziels</translation>
    </message>
    <message>
        <source>Where the middle of the target lies, x in m from the left wall</source>
        <translation>Wo die Mitte des Ziels liegt, x in m von der linken Wand</translation>
    </message>
    <message>
        <source>Width of the target</source>
        <translation>Breite des Ziels</translation>
    </message>
    <message>
        <source>How wide the target is, in m</source>
        <translation>Wie breit das Ziel ist, in m</translation>
    </message>
    <message>
        <source>First cut time</source>
        <translation>Erste Schnittzeit</translation>
    </message>
    <message>
        <source>The earliest moment to cut, in s</source>
        <translation>Der früheste Zeitpunkt zum Schneiden, in s</translation>
    </message>
    <message>
        <source>Last cut time</source>
        <translation>Letzte Schnittzeit</translation>
    </message>
    <message>
        <source>The latest moment to cut, in s</source>
        <translation>Der späteste Zeitpunkt zum Schneiden, in s</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>by</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>Target at</source>
        <translation>Ziel bei</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>must be later than the first</source>
        <translation>muss später als die erste sein</translation>
    </message>
</context>
<context>
    <name>ui::CutResults</name>
    <message>
        <source>when-to-cut</source>
        <translation>schnittzeiten</translation>
    </message>
    <message>
        <source>Copy chart</source>
        <translation>Diagramm kopieren</translation>
    </message>
    <message>
        <source>Copy chart data</source>
        <translation>Diagrammdaten kopieren</translation>
    </message>
    <message>
        <source>Finds where the weight first comes to the floor for every moment of the cut, and the moments that hit the target.</source>
        <translation>Sucht für jede Schnittzeit, wo das Gewicht zuerst auf den Boden kommt, und die Zeitpunkte, die das Ziel treffen.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweep</name>
    <message>
        <source>straight to the floor</source>
        <translation>direkt zum Boden</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Weight %1 never comes to the floor.</source>
        <translation>Gewicht %1 kommt nie auf den Boden.</translation>
    </message>
    <message>
        <source>No cut makes weight %1 hit the target. The nearest is %2 m off, cut at %3 s.</source>
        <translation>Bei keinem Schnitt trifft Gewicht %1 das Ziel. Der nächste liegt %2 m daneben, Schnitt bei %3 s.</translation>
    </message>
    <message>
        <source>off a wall</source>
        <translation>nach Stoß an Wand</translation>
    </message>
    <message>
        <source>off a weight</source>
        <translation>nach Stoß an Gewicht</translation>
    </message>
    <message>
        <source>Weight %1, %2</source>
        <translation>Gewicht %1, %2</translation>
    </message>
    <message>
        <source>; the run cannot go on to the end</source>
        <translation>; der Lauf kommt nicht bis zum Ende</translation>
    </message>
    <message>
        <source>; there are more jumps than can be told apart</source>
        <translation>; es gibt mehr Sprünge, als sich unterscheiden lassen</translation>
    </message>
    <message>
        <source>Of the cut times from %1 s to %2 s, %3 % hit the target. Click the chart, or double-click a row, to cut then.</source>
        <translation>Von den Schnittzeiten zwischen %1 s und %2 s treffen %3 % das Ziel. Klicken Sie ins Diagramm oder doppelklicken Sie auf eine Zeile, um dann zu schneiden.</translation>
    </message>
    <message>
        <source>Cut (s)</source>
        <translation>Schnitt (s)</translation>
    </message>
    <message>
        <source>Lands at (m)</source>
        <translation>Landet bei (m)</translation>
    </message>
    <message>
        <source>Landing (s)</source>
        <translation>Landung (s)</translation>
    </message>
    <message>
        <source>On the way</source>
        <translation>Unterwegs</translation>
    </message>
    <message>
        <source>On the target</source>
        <translation>Im Ziel</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepChart</name>
    <message>
        <source>Landing place against cut time</source>
        <translation>Landeort gegen Schnittzeit</translation>
    </message>
    <message>
        <source>cut at %1 s</source>
        <translation>Schnitt bei %1 s</translation>
    </message>
    <message>
        <source>does not land</source>
        <translation>landet nicht</translation>
    </message>
    <message>
        <source>lands at %1 m</source>
        <translation>landet bei %1 m</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>nach %1 s</translation>
    </message>
    <message>
        <source>A click cuts the ropes at that moment; moments that hit are listed in the table beside it.</source>
        <translation>Ein Klick schneidet die Seile zu diesem Zeitpunkt; Zeitpunkte, die treffen, stehen in der Tabelle daneben.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepPlot</name>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>hits it</source>
        <translation>trifft</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Schnitt bei</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Lands at</source>
        <translation>Landet bei</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
</context>
<context>
    <name>ui::CutWindow</name>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>When to cut?</source>
        <translation>Wann schneiden?</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>Änderung des Schnitts</translation>
    </message>
    <message>
        <source>All ropes are cut at %1 s now. Play to see where weight %2 lands.</source>
        <translation>Alle Seile werden nun bei %1 s durchgeschnitten. Spielen Sie ab, um zu sehen, wo Gewicht %2 landet.</translation>
    </message>
</context>
<context>
    <name>ui::DraftKeeper</name>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>der Ordner %1 kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>nothing can be written to %1</source>
        <translation>in %1 kann nichts geschrieben werden</translation>
    </message>
</context>
<context>
    <name>ui::EnergyChart</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>drift %1 J</source>
        <translation>Drift %1 J</translation>
    </message>
    <message>
        <source>drift %1 J (%2 %)</source>
        <translation>Drift %1 J (%2 %)</translation>
    </message>
    <message>
        <source>drift %1 J (%1 %)</source>
        <translation>Drift %1 J (%1 %)</translation>
    </message>
    <message>
        <source>%1 reaches %2 J</source>
        <translation>%1 erreicht %2 J</translation>
    </message>
    <message>
        <source>Scale ends at %1 %2: %3.</source>
        <translation>Die Skala endet bei %1 %2: %3.</translation>
    </message>
    <message>
        <source> − %1 %2</source>
        <translation> − %1 %2</translation>
    </message>
    <message>
        <source>Numerical drift</source>
        <translation>Numerische Drift</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Kinetic</source>
        <translation>Kinetisch</translation>
    </message>
    <message>
        <source>Potential</source>
        <translation>Potentiell</translation>
    </message>
    <message>
        <source>Lost to air</source>
        <translation>Verlust: Luft</translation>
    </message>
    <message>
        <source>Lost to impacts</source>
        <translation>Verlust: Stöße</translation>
    </message>
    <message>
        <source>Lost to ropes</source>
        <translation>Verlust: Seile</translation>
    </message>
    <message>
        <source>Lost to friction</source>
        <translation>Verlust: Reibung</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
</context>
<context>
    <name>ui::EventNavigator</name>
    <message>
        <source>%1: none between %2 s and %3 s.</source>
        <translation>%1: nichts zwischen %2 s und %3 s.</translation>
    </message>
</context>
<context>
    <name>ui::EventTable</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Before (m/s)</source>
        <translation>Vor (m/s)</translation>
    </message>
    <message>
        <source>After (m/s)</source>
        <translation>Nach (m/s)</translation>
    </message>
    <message>
        <source>Energy lost (J)</source>
        <translation>Verlust (J)</translation>
    </message>
    <message>
        <source>When it happened, t in s</source>
        <translation>Wann es geschah, t in s</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>The weights it happened to, counted from the left</source>
        <translation>Die Gewichte, denen es geschah, von links gezählt</translation>
    </message>
    <message>
        <source>Speed |v| right before, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Tempo |v| unmittelbar davor, in m/s. Des Gewichts; wo zwei sich treffen, des zuerst genannten</translation>
    </message>
    <message>
        <source>Speed |v| right after, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Tempo |v| unmittelbar danach, in m/s. Des Gewichts; wo zwei sich treffen, des zuerst genannten</translation>
    </message>
    <message>
        <source>Kinetic energy turned into heat by the event, in J. Between two weights ½ (1 − e²) μ v², with the speed v towards each other and 1/μ = 1/m₁ + 1/m₂</source>
        <translation>Kinetische Energie, die das Ereignis in Wärme verwandelt, in J. Zwischen zwei Gewichten ½ (1 − e²) μ v², mit dem Tempo v aufeinander zu und 1/μ = 1/m₁ + 1/m₂</translation>
    </message>
</context>
<context>
    <name>ui::EventWords</name>
    <message>
        <source>All events</source>
        <translation>Alle Ereignisse</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Stöße</translation>
    </message>
    <message>
        <source>Turning points</source>
        <translation>Umkehrpunkte</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Ropes slack and taut</source>
        <translation>Schlaffe und straffe Seile</translation>
    </message>
    <message>
        <source>Coming to rest</source>
        <translation>Zur Ruhe kommen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Turning point</source>
        <translation>Umkehrpunkt</translation>
    </message>
    <message>
        <source>Rope slack</source>
        <translation>Seil wird schlaff</translation>
    </message>
    <message>
        <source>Rope taut</source>
        <translation>Seil wird straff</translation>
    </message>
    <message>
        <source>Impact on the floor</source>
        <translation>Stoß am Boden</translation>
    </message>
    <message>
        <source>Impact on the ceiling</source>
        <translation>Stoß an der Decke</translation>
    </message>
    <message>
        <source>Impact on the left wall</source>
        <translation>Stoß an der linken Wand</translation>
    </message>
    <message>
        <source>Impact on the right wall</source>
        <translation>Stoß an der rechten Wand</translation>
    </message>
    <message>
        <source>Impact of weights</source>
        <translation>Stoß von Gewichten</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>Kommt zur Ruhe</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
</context>
<context>
    <name>ui::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Kinds of events</source>
        <translation>Arten von Ereignissen</translation>
    </message>
    <message>
        <source>Weight whose events are listed</source>
        <translation>Gewicht, dessen Ereignisse aufgelistet sind</translation>
    </message>
    <message>
        <source>Weight whose events are listed, counted from the left</source>
        <translation>Gewicht, dessen Ereignisse aufgelistet sind, von links gezählt</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Alle Gewichte</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Gewicht </translation>
    </message>
    <message>
        <source>Run whose events are listed</source>
        <translation>Lauf, dessen Ereignisse aufgelistet sind</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the chosen events as CSV, or all that are listed (Ctrl+C)</source>
        <translation>Die gewählten Ereignisse als CSV kopieren oder alle aufgelisteten (Strg+C)</translation>
    </message>
    <message>
        <source>Events copied as CSV: %1</source>
        <translation>Ereignisse als CSV kopiert: %1</translation>
    </message>
    <message>
        <source>What happened in the run; choosing an event shows its moment</source>
        <translation>Was im Lauf geschah; ein Ereignis zu wählen zeigt seinen Zeitpunkt</translation>
    </message>
    <message>
        <source>Kinds of events that are listed</source>
        <translation>Arten von Ereignissen, die aufgeführt werden</translation>
    </message>
</context>
<context>
    <name>ui::ExportButton</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Save the chart as a picture or its figures as a table</source>
        <translation>Das Diagramm als Bild oder seine Zahlen als Tabelle speichern</translation>
    </message>
    <message>
        <source>Chart…</source>
        <translation>Diagramm…</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabelle…</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Tabelle exportieren</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::Exports</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Export picture of the scene</source>
        <translation>Bild der Szene exportieren</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>szene</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energie</translation>
    </message>
    <message>
        <source>Export energy ledger</source>
        <translation>Energiebilanz exportieren</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Not exported</source>
        <translation>Nicht exportiert</translation>
    </message>
    <message>
        <source>%1 was not written:
%2</source>
        <translation>%1 wurde nicht geschrieben:
%2</translation>
    </message>
</context>
<context>
    <name>ui::FileDialog</name>
    <message>
        <source>scene</source>
        <translation>szene</translation>
    </message>
</context>
<context>
    <name>ui::FirstScene</name>
    <message>
        <source>The scene of last time, %1, was not opened: %2</source>
        <translation>Die letzte Szene, %1, wurde nicht geöffnet: %2</translation>
    </message>
</context>
<context>
    <name>ui::Form</name>
    <message>
        <source>change of %1</source>
        <translation>Änderung von „%1“</translation>
    </message>
</context>
<context>
    <name>ui::HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>About Angry Cuts</source>
        <translation>Über Angry Cuts</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Weights hang on ropes and swing; the ropes are cut; the weights fly, bounce and come to rest. Two numerical methods compute the same scene side by side, and an energy ledger shows what each of them gets wrong.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Gewichte hängen an Seilen und schwingen; die Seile werden durchgeschnitten; die Gewichte fliegen, prallen ab und kommen zur Ruhe. Zwei numerische Verfahren berechnen dieselbe Szene nebeneinander, und eine Energiebilanz zeigt, was jedes von ihnen falsch macht.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Quick guide</source>
        <translation>Kurzanleitung</translation>
    </message>
    <message>
        <source>The model</source>
        <translation>Das Modell</translation>
    </message>
    <message>
        <source>Teacher&apos;s sheets</source>
        <translation>Lehrerblätter</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Drucken…</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>Als PDF &amp;speichern…</translation>
    </message>
    <message>
        <source>Printed %1</source>
        <translation>%1 gedruckt</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Als PDF speichern</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>Guide, model or teacher&apos;s sheets</source>
        <translation>Anleitung, Modell oder Lehrerblätter</translation>
    </message>
    <message>
        <source>What this chapter has; the one chosen is shown</source>
        <translation>Was dieses Kapitel enthält; das Gewählte wird gezeigt</translation>
    </message>
    <message>
        <source>The page that is open</source>
        <translation>Die geöffnete Seite</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>Print these pages, black on white</source>
        <translation>Diese Seiten drucken, schwarz auf weiß</translation>
    </message>
    <message>
        <source>Save these pages as a file</source>
        <translation>Diese Seiten als Datei speichern</translation>
    </message>
</context>
<context>
    <name>ui::HitTable</name>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Schnitt bei</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Dauert</translation>
    </message>
    <message>
        <source>Lands</source>
        <translation>Landet</translation>
    </message>
    <message>
        <source>Off a</source>
        <translation>Stoß an</translation>
    </message>
    <message>
        <source>The moment that comes nearest to the target&apos;s center</source>
        <translation>Der Zeitpunkt, der der Mitte des Ziels am nächsten kommt</translation>
    </message>
    <message>
        <source>How long the stretch of cut times is that hit</source>
        <translation>Wie lang das Intervall der Schnittzeiten ist, die treffen</translation>
    </message>
    <message>
        <source>When the weight lands</source>
        <translation>Wann das Gewicht landet</translation>
    </message>
    <message>
        <source>What it hits first, before the floor</source>
        <translation>Was es zuerst trifft, vor dem Boden</translation>
    </message>
    <message>
        <source>Moments that hit</source>
        <translation>Zeitpunkte, die treffen</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to cut then</source>
        <translation>Doppelklicken Sie auf eine Zeile oder drücken Sie die Eingabetaste, um dann zu schneiden</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>ui::JsonCursor</name>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>the text ends where a value must stand</source>
        <translation>der Text endet, wo ein Wert stehen muss</translation>
    </message>
    <message>
        <source>a value must stand here</source>
        <translation>hier muss ein Wert stehen</translation>
    </message>
    <message>
        <source>a digit must stand here</source>
        <translation>hier muss eine Ziffer stehen</translation>
    </message>
    <message>
        <source>the text ends inside a string</source>
        <translation>der Text endet in einer Zeichenkette</translation>
    </message>
    <message>
        <source>a control character must be written as an escape</source>
        <translation>ein Steuerzeichen muss als Escape-Sequenz geschrieben werden</translation>
    </message>
    <message>
        <source>unknown escape in a string</source>
        <translation>unbekannte Escape-Sequenz in einer Zeichenkette</translation>
    </message>
    <message>
        <source>half a surrogate pair in a string</source>
        <translation>ein halbes Surrogatpaar in einer Zeichenkette</translation>
    </message>
    <message>
        <source>four hexadecimal digits must stand here</source>
        <translation>hier müssen vier hexadezimale Ziffern stehen</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>zu tief verschachtelt</translation>
    </message>
    <message>
        <source>a comma or %1 must stand here</source>
        <translation>hier muss ein Komma oder %1 stehen</translation>
    </message>
    <message>
        <source>a key in quotes must stand here</source>
        <translation>hier muss ein Schlüssel in Anführungszeichen stehen</translation>
    </message>
    <message>
        <source>a colon must stand here</source>
        <translation>hier muss ein Doppelpunkt stehen</translation>
    </message>
    <message>
        <source>nothing more may stand here</source>
        <translation>hier darf nichts mehr stehen</translation>
    </message>
</context>
<context>
    <name>ui::KeysPage</name>
    <message>
        <source>%1, previous</source>
        <translation>%1, zurück</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>In der Szene</translation>
    </message>
    <message>
        <source>Wheel, drag</source>
        <translation>Rad, Ziehen</translation>
    </message>
    <message>
        <source>Zoom, move the view</source>
        <translation>Zoomen, verschieben</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Fit the room</source>
        <translation>Raum einpassen</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Select a weight</source>
        <translation>Gewicht auswählen</translation>
    </message>
    <message>
        <source>Drag a weight</source>
        <translation>Gewicht ziehen</translation>
    </message>
    <message>
        <source>Set its angle or place</source>
        <translation>Winkel oder Ort setzen</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umsch+Ziehen</translation>
    </message>
    <message>
        <source>Set its rope&apos;s length</source>
        <translation>Seillänge setzen</translation>
    </message>
    <message>
        <source>Drag its arrow</source>
        <translation>Pfeil ziehen</translation>
    </message>
    <message>
        <source>Set its velocity</source>
        <translation>Geschwindigkeit setzen</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Einrasten</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+Pfeile</translation>
    </message>
    <message>
        <source>Move the weight</source>
        <translation>Gewicht bewegen</translation>
    </message>
    <message>
        <source>Alt+Shift+arrows</source>
        <translation>Alt+Umsch+Pfeile</translation>
    </message>
    <message>
        <source>Change its velocity</source>
        <translation>Geschwindigkeit ändern</translation>
    </message>
    <message>
        <source>In the table</source>
        <translation>In der Tabelle</translation>
    </message>
    <message>
        <source>Ins, Del</source>
        <translation>Einfg, Entf</translation>
    </message>
    <message>
        <source>Add, remove weights</source>
        <translation>Gewichte dazu, weg</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Strg+C, Strg+V</translation>
    </message>
    <message>
        <source>Copy, paste cells</source>
        <translation>Kopieren, einfügen</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Strg+D</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Nach unten füllen</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>In einem Diagramm</translation>
    </message>
    <message>
        <source>Wheel, + −</source>
        <translation>Rad, + −</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Auf Rahmen zoomen</translation>
    </message>
    <message>
        <source>Shift+drag, Alt+arrows</source>
        <translation>Umsch+Ziehen, Alt+Pfeile</translation>
    </message>
    <message>
        <source>Move what it shows</source>
        <translation>Ausschnitt verschieben</translation>
    </message>
    <message>
        <source>Double click, 0</source>
        <translation>Doppelklick, 0</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Return, Escape</source>
        <translation>Eingabetaste, Esc</translation>
    </message>
    <message>
        <source>Apply, restore a field</source>
        <translation>Übernehmen, verwerfen</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umsch+Tab</translation>
    </message>
    <message>
        <source>Next, previous field</source>
        <translation>Feld vor, zurück</translation>
    </message>
    <message>
        <source>Alt+letter</source>
        <translation>Alt+Buchstabe</translation>
    </message>
    <message>
        <source>Open that menu</source>
        <translation>Menü öffnen</translation>
    </message>
</context>
<context>
    <name>ui::LessonChooser</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Arrow keys and Enter, or a click, open a lesson.</source>
        <translation>Pfeiltasten und Eingabetaste oder ein Klick öffnen eine Lektion.</translation>
    </message>
</context>
<context>
    <name>ui::LessonPanel</name>
    <message>
        <source>To try</source>
        <translation>Zum Probieren</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
</context>
<context>
    <name>ui::Lessons</name>
    <message>
        <source>One pendulum</source>
        <translation>Ein Pendel</translation>
    </message>
    <message>
        <source>Watch one weight swing, lose its rope on the way up, fly and bounce: Euler swings higher than it started, RK4 does not.</source>
        <translation>Beobachten Sie, wie ein Gewicht schwingt, auf dem Weg nach oben sein Seil verliert, fliegt und abprallt: Mit Euler schwingt es höher, als es begann, mit RK4 nicht.</translation>
    </message>
    <message>
        <source>Press R, then cut the rope yourself with C: when must you cut for the longest throw?</source>
        <translation>Drücken Sie R und schneiden Sie das Seil dann selbst mit C durch: Wann müssen Sie schneiden, damit der Wurf am weitesten geht?</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller under Runs: about a tenth of its error is left.</source>
        <translation>Geben Sie Euler unter „Läufe“ eine zehnmal kleinere Schrittweite: Etwa ein Zehntel des Fehlers bleibt übrig.</translation>
    </message>
    <message>
        <source>Set the air density to 0: does the total still stay flat with both methods?</source>
        <translation>Setzen Sie die Luftdichte auf 0: Bleibt die Gesamtenergie mit beiden Verfahren noch konstant?</translation>
    </message>
    <message>
        <source>Two weights</source>
        <translation>Zwei Gewichte</translation>
    </message>
    <message>
        <source>Watch a small and a large weight of the same lead swing towards each other: when they meet in the air, the light one is thrown back.</source>
        <translation>Beobachten Sie, wie ein kleines und ein großes Gewicht aus demselben Blei aufeinander zu schwingen: Treffen sie sich in der Luft, wird das leichte zurückgeworfen.</translation>
    </message>
    <message>
        <source>Press I to go to the impact and read the speeds before and after under Events.</source>
        <translation>Drücken Sie I, um zum Stoß zu gehen, und lesen Sie unter „Ereignisse“ die Geschwindigkeiten vorher und nachher ab.</translation>
    </message>
    <message>
        <source>Give both weights the same mass: who is thrown back now?</source>
        <translation>Geben Sie beiden Gewichten dieselbe Masse: Welches wird jetzt zurückgeworfen?</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0: how much energy is lost to the impact?</source>
        <translation>Setzen Sie die Stoßzahl der Gewichte auf 0: Wie viel Energie geht beim Stoß verloren?</translation>
    </message>
    <message>
        <source>Three pendulums</source>
        <translation>Drei Pendel</translation>
    </message>
    <message>
        <source>Watch three ropes of different length start together and fall out of step: the longer the rope, the slower the swing.</source>
        <translation>Beobachten Sie, wie drei verschieden lange Seile zusammen starten und außer Takt geraten: Je länger das Seil, desto langsamer die Schwingung.</translation>
    </message>
    <message>
        <source>Make the first rope 0.3 m long: the third, four times as long, swings half as fast.</source>
        <translation>Machen Sie das erste Seil 0,3 m lang: Das dritte, viermal so lange, schwingt halb so schnell.</translation>
    </message>
    <message>
        <source>Change the mass of one weight: is its swing slower now?</source>
        <translation>Ändern Sie die Masse eines Gewichts: Schwingt es jetzt langsamer?</translation>
    </message>
    <message>
        <source>Press U to go from one turning point to the next and read the times under Events.</source>
        <translation>Drücken Sie U, um von einem Umkehrpunkt zum nächsten zu gehen, und lesen Sie die Zeiten unter „Ereignisse“ ab.</translation>
    </message>
    <message>
        <source>Seven weights in a room</source>
        <translation>Sieben Gewichte im Raum</translation>
    </message>
    <message>
        <source>Watch seven weights swing, all ropes cut at once: they fly, bounce off each other, the walls and the floor, and two methods soon disagree about where.</source>
        <translation>Beobachten Sie, wie sieben Gewichte schwingen und alle Seile zugleich durchgeschnitten werden: Sie fliegen, prallen aneinander, an Wänden und am Boden ab, und bald sind sich zwei Verfahren uneins, wo sie sind.</translation>
    </message>
    <message>
        <source>Press V to give each method a view of its own.</source>
        <translation>Drücken Sie V, um jedem Verfahren eine eigene Ansicht zu geben.</translation>
    </message>
    <message>
        <source>Guess which weight comes to rest first, and look it up under Events.</source>
        <translation>Raten Sie, welches Gewicht zuerst zur Ruhe kommt, und sehen Sie unter „Ereignisse“ nach.</translation>
    </message>
    <message>
        <source>Halve the step of one method: how much later do the two part?</source>
        <translation>Halbieren Sie die Schrittweite eines Verfahrens: Wie viel später trennen sich die beiden?</translation>
    </message>
    <message>
        <source>Euler gains energy</source>
        <translation>Euler gewinnt Energie</translation>
    </message>
    <message>
        <source>Watch Euler swing a pendulum higher and higher without a push, until it goes over the top: its energy comes from the method, not from physics.</source>
        <translation>Beobachten Sie, wie Euler ein Pendel ohne Anstoß immer höher schwingen lässt, bis es sich überschlägt: Seine Energie kommt vom Verfahren, nicht aus der Physik.</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller: it still gains energy, only more slowly.</source>
        <translation>Geben Sie Euler eine zehnmal kleinere Schrittweite: Es gewinnt immer noch Energie, nur langsamer.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: all that is hatched was made by the method.</source>
        <translation>Öffnen Sie das Diagramm „Bilanz“: Alles Schraffierte hat das Verfahren erzeugt.</translation>
    </message>
    <message>
        <source>Choose Euler (semi-implicit) for the second run and compare.</source>
        <translation>Wählen Sie Euler (semi-implizit) für den zweiten Lauf und vergleichen Sie.</translation>
    </message>
    <message>
        <source>Two kinds of Euler</source>
        <translation>Zwei Arten von Euler</translation>
    </message>
    <message>
        <source>Watch two methods that differ in a single line, whether the new or the old speed moves the weight: one gains energy for ever, the other never strays far.</source>
        <translation>Beobachten Sie zwei Verfahren, die sich in einer einzigen Zeile unterscheiden, nämlich ob die neue oder die alte Geschwindigkeit das Gewicht bewegt: Das eine gewinnt ewig Energie, das andere weicht nie weit ab.</translation>
    </message>
    <message>
        <source>Open the Phase chart: one draws a closed loop, the other a spiral.</source>
        <translation>Öffnen Sie das Diagramm „Phase“: Das eine zeichnet eine geschlossene Kurve, das andere eine Spirale.</translation>
    </message>
    <message>
        <source>Switch on Runge–Kutta 4 as a third run with the same step: what does its energy do?</source>
        <translation>Schalten Sie Runge–Kutta 4 als dritten Lauf mit derselben Schrittweite ein: Was macht seine Energie?</translation>
    </message>
    <message>
        <source>Let it play for a minute at speed 8×: is the first run still the same?</source>
        <translation>Lassen Sie eine Minute mit Ablauf 8× abspielen: Ist der erste Lauf noch derselbe?</translation>
    </message>
    <message>
        <source>Half the step</source>
        <translation>Halbe Schrittweite</translation>
    </message>
    <message>
        <source>Watch the distance from the first run, which is exact: with half the step Euler errs half as much, and RK4 hardly at all.</source>
        <translation>Beobachten Sie den Abstand vom ersten Lauf, der exakt ist: Mit halber Schrittweite irrt Euler halb so viel und RK4 kaum noch.</translation>
    </message>
    <message>
        <source>Open Comparison and read the distances after one second and after four.</source>
        <translation>Öffnen Sie „Vergleich“ und lesen Sie die Abstände nach einer Sekunde und nach vier ab.</translation>
    </message>
    <message>
        <source>Halve the step of Runge–Kutta 4: its error shrinks to about a sixteenth.</source>
        <translation>Halbieren Sie die Schrittweite von Runge–Kutta 4: Der Fehler schrumpft auf etwa ein Sechzehntel.</translation>
    </message>
    <message>
        <source>Open Run ▸ Speed and accuracy to see the same for many steps at once.</source>
        <translation>Öffnen Sie Lauf ▸ Rechenzeit und Genauigkeit, um dasselbe für viele Schrittweiten auf einmal zu sehen.</translation>
    </message>
    <message>
        <source>Step too large</source>
        <translation>Zu große Schrittweite</translation>
    </message>
    <message>
        <source>Watch the air stop a balloon in three ways: slowly with a small step, dead with a larger one, and never with one that throws it back faster each time.</source>
        <translation>Beobachten Sie, wie die Luft einen Ballon auf drei Arten bremst: langsam mit kleiner Schrittweite, schlagartig mit größerer und nie mit einer, die ihn jedes Mal schneller zurückwirft.</translation>
    </message>
    <message>
        <source>Press R and then → again and again: see how each large step overshoots.</source>
        <translation>Drücken Sie R und dann immer wieder →: Sehen Sie, wie jeder große Schritt über das Ziel hinausschießt.</translation>
    </message>
    <message>
        <source>Open Inside a step for the third run: its one slope points far beyond the other side.</source>
        <translation>Öffnen Sie „Einzelschritt“ für den dritten Lauf: Seine einzige Steigung weist weit über die andere Seite hinaus.</translation>
    </message>
    <message>
        <source>Look for the largest step of the third run that does not blow up.</source>
        <translation>Suchen Sie die größte Schrittweite, bei der der dritte Lauf nicht divergiert.</translation>
    </message>
    <message>
        <source>Small and large swings</source>
        <translation>Kleine und große Schwingungen</translation>
    </message>
    <message>
        <source>Watch four pendulums of the same length start together: only small swings keep the same time, and the wider one swings, the longer it takes.</source>
        <translation>Beobachten Sie, wie vier gleich lange Pendel zusammen starten: Nur kleine Schwingungen bleiben im selben Takt, und je weiter eines schwingt, desto länger braucht es.</translation>
    </message>
    <message>
        <source>Press U to find the first turning points and compare the times.</source>
        <translation>Drücken Sie U, um die ersten Umkehrpunkte zu finden, und vergleichen Sie die Zeiten.</translation>
    </message>
    <message>
        <source>Set the start angles to 5°, 10°, 15° and 20°: now they keep step for a long time.</source>
        <translation>Setzen Sie die Startwinkel auf 5°, 10°, 15° und 20°: Jetzt bleiben sie lange im Takt.</translation>
    </message>
    <message>
        <source>Set one start angle to 179.9°: how long does it stay near the top?</source>
        <translation>Setzen Sie einen Startwinkel auf 179,9°: Wie lange bleibt das Pendel in der Nähe des höchsten Punkts?</translation>
    </message>
    <message>
        <source>Slack rope</source>
        <translation>Schlaffes Seil</translation>
    </message>
    <message>
        <source>Watch a rod and a rope with the same push: the rod carries its weight over the top, the rope goes slack on the way up and jerks tight on the way down.</source>
        <translation>Beobachten Sie eine Stange und ein Seil mit demselben Anstoß: Die Stange trägt ihr Gewicht über den höchsten Punkt, das Seil wird auf dem Weg nach oben schlaff und auf dem Weg nach unten mit einem Ruck straff.</translation>
    </message>
    <message>
        <source>Switch to speed 1/8× at the moment the rope goes slack: the weight flies as if thrown.</source>
        <translation>Schalten Sie in dem Moment, in dem das Seil schlaff wird, auf Ablauf 1/8×: Das Gewicht fliegt wie geworfen.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: how much energy does the jerk cost?</source>
        <translation>Öffnen Sie das Diagramm „Bilanz“: Wie viel Energie kostet der Ruck?</translation>
    </message>
    <message>
        <source>Change gravity until the rope stays taut all the way round.</source>
        <translation>Ändern Sie die Fallbeschleunigung, bis das Seil den ganzen Umlauf lang straff bleibt.</translation>
    </message>
    <message>
        <source>A throw with and without air</source>
        <translation>Ein Wurf mit und ohne Luft</translation>
    </message>
    <message>
        <source>Watch two equal throws, one through air and one that the air does not touch: with air the path is shorter, lower and steeper at its end.</source>
        <translation>Beobachten Sie zwei gleiche Würfe, einen durch Luft und einen, den die Luft nicht berührt: Mit Luft ist die Bahn kürzer, niedriger und am Ende steiler.</translation>
    </message>
    <message>
        <source>Open the Paths chart: which of the two paths is a parabola?</source>
        <translation>Öffnen Sie das Diagramm „Bahnen“: Welche der beiden Bahnen ist eine Parabel?</translation>
    </message>
    <message>
        <source>Make the first ball ten times as heavy: how much further does it get?</source>
        <translation>Machen Sie den ersten Ball zehnmal so schwer: Wie viel weiter kommt er?</translation>
    </message>
    <message>
        <source>Set the air density to 0: now both paths have the same shape.</source>
        <translation>Setzen Sie die Luftdichte auf 0: Jetzt haben beide Bahnen dieselbe Form.</translation>
    </message>
    <message>
        <source>Terminal velocity</source>
        <translation>Endgeschwindigkeit</translation>
    </message>
    <message>
        <source>Watch three balls of one size fall: the light ones soon fall at a constant speed, where the drag of the air is as large as their weight.</source>
        <translation>Beobachten Sie, wie drei gleich große Bälle fallen: Die leichten fallen bald mit konstantem Tempo, bei dem der Luftwiderstand so groß ist wie ihre Gewichtskraft.</translation>
    </message>
    <message>
        <source>Open the Speed chart: whose curve becomes level, and how soon?</source>
        <translation>Öffnen Sie das Diagramm „Tempo“: Wessen Kurve wird waagerecht, und wie bald?</translation>
    </message>
    <message>
        <source>Read off both level speeds: the second ball is four times as heavy as the first.</source>
        <translation>Lesen Sie beide Endgeschwindigkeiten ab: Der zweite Ball ist viermal so schwer wie der erste.</translation>
    </message>
    <message>
        <source>Set the air density to 0: all three hit the floor together.</source>
        <translation>Setzen Sie die Luftdichte auf 0: Alle drei treffen zugleich auf dem Boden auf.</translation>
    </message>
    <message>
        <source>Infinitely many bounces</source>
        <translation>Unendlich viele Sprünge</translation>
    </message>
    <message>
        <source>Watch a ball that loses a fifth of its speed at every bounce: it bounces infinitely often, and yet all bounces are over within six seconds.</source>
        <translation>Beobachten Sie einen Ball, der bei jedem Sprung ein Fünftel seiner Geschwindigkeit verliert: Er springt unendlich oft, und doch sind alle Sprünge binnen sechs Sekunden vorbei.</translation>
    </message>
    <message>
        <source>Open the Height chart and zoom in on the end: it looks the same again and again.</source>
        <translation>Öffnen Sie das Diagramm „Höhe“ und zoomen Sie auf das Ende: Es sieht immer wieder gleich aus.</translation>
    </message>
    <message>
        <source>Go to the last impacts with I: the times between them form a geometric series.</source>
        <translation>Gehen Sie mit I zu den letzten Stößen: Die Zeiten dazwischen bilden eine geometrische Reihe.</translation>
    </message>
    <message>
        <source>Set the restitution of walls to 0.9: the bounces now last about twice as long.</source>
        <translation>Setzen Sie die Stoßzahl der Wände auf 0,9: Die Sprünge dauern jetzt etwa doppelt so lang.</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>Newtons Wiege</translation>
    </message>
    <message>
        <source>Watch one weight knock against four that hang at rest: only the last one flies off, because energy and momentum must both be kept.</source>
        <translation>Beobachten Sie, wie ein Gewicht gegen vier ruhig hängende stößt: Nur das letzte fliegt weg, denn Energie und Impuls müssen beide erhalten bleiben.</translation>
    </message>
    <message>
        <source>Pull two weights aside: give weight 2 the start angle −40°, too. How many fly off?</source>
        <translation>Lenken Sie zwei Gewichte aus: Geben Sie auch Gewicht 2 den Startwinkel −40°. Wie viele fliegen weg?</translation>
    </message>
    <message>
        <source>Play the impacts at speed 1/64×: the push passes through four weights in no time.</source>
        <translation>Spielen Sie die Stöße mit Ablauf 1/64× ab: Der Stoß läuft augenblicklich durch vier Gewichte.</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0.5: after a while all swing together.</source>
        <translation>Setzen Sie die Stoßzahl der Gewichte auf 0,5: Nach einer Weile schwingen alle gemeinsam.</translation>
    </message>
    <message>
        <source>Counting π by impacts</source>
        <translation>π zählen mit Stößen</translation>
    </message>
    <message>
        <source>Watch a disc a hundred times as heavy drive a light one against the wall: there are 31 impacts before they part, the first digits of π.</source>
        <translation>Beobachten Sie, wie eine hundertmal so schwere Scheibe eine leichte gegen die Wand treibt: Es gibt 31 Stöße, bevor sie sich trennen, die ersten Ziffern von π.</translation>
    </message>
    <message>
        <source>Open Events and choose Impacts: count them until the heavy disc hits the right wall.</source>
        <translation>Öffnen Sie „Ereignisse“ und wählen Sie „Stöße“: Zählen Sie, bis die schwere Scheibe die rechte Wand trifft.</translation>
    </message>
    <message>
        <source>Make the heavy disc 1000 kg, 10⁴ times the light one: there are 314 impacts.</source>
        <translation>Machen Sie die schwere Scheibe 1000 kg schwer, das 10⁴-Fache der leichten: Es gibt 314 Stöße.</translation>
    </message>
    <message>
        <source>Give the run a step ten times as large: the number stays the same. Why?</source>
        <translation>Geben Sie dem Lauf eine zehnmal so große Schrittweite: Die Anzahl bleibt gleich. Warum?</translation>
    </message>
    <message>
        <source>A thousand pendulums</source>
        <translation>Tausend Pendel</translation>
    </message>
    <message>
        <source>Watch a thousand pendulums start as one straight line, each a hair longer than the next: the line bends, winds up and falls apart into dust.</source>
        <translation>Beobachten Sie, wie tausend Pendel als eine gerade Linie starten, jedes um Haaresbreite länger als das vorige: Die Linie biegt sich, wickelt sich auf und zerfällt zu Staub.</translation>
    </message>
    <message>
        <source>Stop after 5 s and after 20 s: are weights that started side by side still neighbours?</source>
        <translation>Halten Sie nach 5 s und nach 20 s an: Sind Gewichte, die nebeneinander starteten, noch Nachbarn?</translation>
    </message>
    <message>
        <source>Set all start angles to 170°: does the line fall apart sooner?</source>
        <translation>Setzen Sie alle Startwinkel auf 170°: Zerfällt die Linie früher?</translation>
    </message>
    <message>
        <source>Press C while they swing: a thousand weights fly off along a thousand paths.</source>
        <translation>Drücken Sie C, während sie schwingen: Tausend Gewichte fliegen auf tausend Bahnen davon.</translation>
    </message>
    <message>
        <source>A pile comes to rest</source>
        <translation>Ein Haufen kommt zur Ruhe</translation>
    </message>
    <message>
        <source>Watch balls rain into a box and settle: every impact takes some energy, until all lie still and no ball overlaps another.</source>
        <translation>Beobachten Sie, wie Bälle in einen Kasten regnen und sich setzen: Jeder Stoß nimmt etwas Energie, bis alle still liegen und kein Ball einen anderen überlappt.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: where has all the energy gone?</source>
        <translation>Öffnen Sie das Diagramm „Bilanz“: Wo ist die ganze Energie geblieben?</translation>
    </message>
    <message>
        <source>Set both restitutions to 0.8: how much longer does it take until all lie still?</source>
        <translation>Setzen Sie beide Stoßzahlen auf 0,8: Wie viel länger dauert es, bis alle still liegen?</translation>
    </message>
    <message>
        <source>Make the room twice as wide: how high is the pile now?</source>
        <translation>Machen Sie den Raum doppelt so breit: Wie hoch ist der Haufen jetzt?</translation>
    </message>
</context>
<context>
    <name>ui::LogScale</name>
    <message>
        <source>1/%1 s</source>
        <translation>1/%1 s</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>ui::MainMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Built-in scenes</source>
        <translation>&amp;Eingebaute Szenen</translation>
    </message>
    <message>
        <source>Export energy &amp;ledger</source>
        <translation>Ener&amp;giebilanz exportieren</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Lauf</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Gehe zu</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bereiche</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>&amp;Gewicht</translation>
    </message>
    <message>
        <source>&amp;Chart</source>
        <translation>D&amp;iagramm</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Which of the panels that share this place is shown</source>
        <translation>Welcher der Bereiche an dieser Stelle gezeigt wird</translation>
    </message>
</context>
<context>
    <name>ui::MeasurementTable</name>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Time/s</source>
        <translation>Zeit/s</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Steigungen</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Step, or tolerance of an adaptive method</source>
        <translation>Schrittweite, oder Toleranz eines adaptiven Verfahrens</translation>
    </message>
    <message>
        <source>Largest distance of any weight from where it really is</source>
        <translation>Größter Abstand eines Gewichts von seinem wahren Ort</translation>
    </message>
    <message>
        <source>Largest numerical drift of the energy</source>
        <translation>Größte numerische Drift der Energie</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Rechenzeit pro simulierter Sekunde</translation>
    </message>
    <message>
        <source>Slope evaluations</source>
        <translation>Steigungsberechnungen</translation>
    </message>
    <message>
        <source>Whether the run came to the end</source>
        <translation>Ob der Lauf bis zum Ende kam</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to open it as a run</source>
        <translation>Doppelklicken Sie auf eine Zeile oder drücken Sie die Eingabetaste, um sie als Lauf zu öffnen</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>diverged at %1 s</source>
        <translation>divergiert bei %1 s</translation>
    </message>
</context>
<context>
    <name>ui::OpenAsRun</name>
    <message>
        <source>addition of a run</source>
        <translation>Hinzufügen eines Laufs</translation>
    </message>
</context>
<context>
    <name>ui::PanelTitle</name>
    <message>
        <source>Take the panel out of the window, or put it back</source>
        <translation>Den Bereich aus dem Fenster lösen oder zurücksetzen</translation>
    </message>
    <message>
        <source>Close the panel; the view menu brings it back</source>
        <translation>Den Bereich schließen; das Menü „Ansicht“ holt ihn zurück</translation>
    </message>
</context>
<context>
    <name>ui::PlaybackBar</name>
    <message>
        <source>%1× real time</source>
        <translation>%1× Echtzeit</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Ablauftempo</translation>
    </message>
    <message>
        <source>Speed (, and .)</source>
        <translation>Ablauftempo (, und .)</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>Whether the computer keeps up with the chosen speed</source>
        <translation>Ob der Computer mit dem gewählten Ablauftempo Schritt hält</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>in real time</source>
        <translation>in Echtzeit</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Ablauf %1</translation>
    </message>
    <message>
        <source>Simulated seconds in a second of real time</source>
        <translation>Simulierte Sekunden in einer wirklichen Sekunde</translation>
    </message>
    <message>
        <source>Simulated time t, in s: the moment that all views show</source>
        <translation>Simulierte Zeit t, in s: der Zeitpunkt, den alle Ansichten zeigen</translation>
    </message>
</context>
<context>
    <name>ui::PresentationHeader</name>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>ui::ProblemLine</name>
    <message>
        <source>must be at least %1, got %2</source>
        <translation>muss mindestens %1 sein, ist aber %2</translation>
    </message>
    <message>
        <source>must be from %1 to %2, got %3</source>
        <translation>muss von %1 bis %2 sein, ist aber %3</translation>
    </message>
    <message>
        <source>must be inside the room, got %1</source>
        <translation>muss im Raum liegen, ist aber %1</translation>
    </message>
    <message>
        <source>must put the whole weight, of radius %1 m, inside the room, got %2</source>
        <translation>muss das ganze Gewicht, mit Radius %1 m, im Raum halten, ist aber %2</translation>
    </message>
    <message>
        <source>must not overlap %1 at the start</source>
        <translation>darf %1 beim Start nicht überlappen</translation>
    </message>
    <message>
        <source>must be at most %1, got %2</source>
        <translation>darf höchstens %1 sein, ist aber %2</translation>
    </message>
</context>
<context>
    <name>ui::ProblemWords</name>
    <message>
        <source>Gravity</source>
        <translation>Die Fallbeschleunigung</translation>
    </message>
    <message>
        <source>The air density</source>
        <translation>Die Luftdichte</translation>
    </message>
    <message>
        <source>The room&apos;s width</source>
        <translation>Die Breite des Raums</translation>
    </message>
    <message>
        <source>The room&apos;s height</source>
        <translation>Die Höhe des Raums</translation>
    </message>
    <message>
        <source>The room&apos;s restitution</source>
        <translation>Die Stoßzahl der Wände</translation>
    </message>
    <message>
        <source>The friction</source>
        <translation>Die Reibungszahl</translation>
    </message>
    <message>
        <source>The weights&apos; restitution</source>
        <translation>Die Stoßzahl der Gewichte</translation>
    </message>
    <message>
        <source>The time of the cut</source>
        <translation>Die Schnittzeit</translation>
    </message>
    <message>
        <source>The mass</source>
        <translation>Die Masse</translation>
    </message>
    <message>
        <source>The radius</source>
        <translation>Der Radius</translation>
    </message>
    <message>
        <source>The drag coefficient</source>
        <translation>Der Widerstandsbeiwert</translation>
    </message>
    <message>
        <source>The rope&apos;s length</source>
        <translation>Die Seillänge</translation>
    </message>
    <message>
        <source>The start angle</source>
        <translation>Der Startwinkel</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Die Schrittweite</translation>
    </message>
    <message>
        <source>The rope of weight %1 is tied outside the room.</source>
        <translation>Das Seil von Gewicht %1 ist außerhalb des Raums befestigt.</translation>
    </message>
    <message>
        <source>Weight %1 does not start inside the room.</source>
        <translation>Gewicht %1 startet nicht im Raum.</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 muss %2 betragen.</translation>
    </message>
    <message>
        <source>%1 (number %2) must be %3.</source>
        <translation>%1 (Nummer %2) muss %3 betragen.</translation>
    </message>
    <message>
        <source>Weights %1 and %2 overlap at the start.</source>
        <translation>Die Gewichte %1 und %2 überlappen sich beim Start.</translation>
    </message>
    <message numerus="yes">
        <source>(and %n more problem(s))</source>
        <translation>
            <numerusform>(und %n weiteres Problem)</numerusform>
            <numerusform>(und %n weitere Probleme)</numerusform>
        </translation>
    </message>
    <message>
        <source>The angular velocity</source>
        <translation>Die Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>The velocity x</source>
        <translation>Die Geschwindigkeit x</translation>
    </message>
    <message>
        <source>The velocity y</source>
        <translation>Die Geschwindigkeit y</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>Die Toleranz</translation>
    </message>
    <message>
        <source>There are more than %1 runs.</source>
        <translation>Es gibt mehr als %1 Läufe.</translation>
    </message>
    <message>
        <source>There are more than %1 weights.</source>
        <translation>Es gibt mehr als %1 Gewichte.</translation>
    </message>
</context>
<context>
    <name>ui::QuantityField</name>
    <message>
        <source>Must be %1</source>
        <translation>Muss %1 betragen</translation>
    </message>
</context>
<context>
    <name>ui::QuantitySpinBox</name>
    <message>
        <source>several</source>
        <translation>verschieden</translation>
    </message>
</context>
<context>
    <name>ui::Range</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>ui::RecentFiles</name>
    <message>
        <source>%1 (gone)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>Diese Liste &amp;leeren</translation>
    </message>
    <message>
        <source>The file is no longer there. It is taken off the list.</source>
        <translation>Die Datei ist nicht mehr da. Sie wird aus der Liste entfernt.</translation>
    </message>
</context>
<context>
    <name>ui::Recovery</name>
    <message>
        <source>The program ended before changes of %1 were saved, on %2.</source>
        <translation>Das Programm endete am %2, bevor Änderungen an %1 gespeichert waren.</translation>
    </message>
    <message>
        <source>a new scene</source>
        <translation>einer neuen Szene</translation>
    </message>
    <message>
        <source>recovery of changes</source>
        <translation>Wiederherstellung von Änderungen</translation>
    </message>
</context>
<context>
    <name>ui::RunWords</name>
    <message>
        <source>Euler (explicit)</source>
        <translation>Euler (explizit)</translation>
    </message>
    <message>
        <source>Euler (semi-implicit)</source>
        <translation>Euler (semi-implizit)</translation>
    </message>
    <message>
        <source>Runge–Kutta 4</source>
        <translation>Runge–Kutta 4</translation>
    </message>
    <message>
        <source>Dormand–Prince 5(4)</source>
        <translation>Dormand–Prince 5(4)</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, Toleranz %2</translation>
    </message>
    <message>
        <source>%1, %2 s</source>
        <translation>%1, %2 s</translation>
    </message>
    <message>
        <source>%1, diverged at %2 s. Its last finite state is shown; try a smaller step.</source>
        <translation>%1, divergiert bei %2 s. Der letzte endliche Zustand wird gezeigt; versuchen Sie eine kleinere Schrittweite.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: one step held more impacts than a step may.</source>
        <translation>%1, angehalten bei %2 s: Ein Schritt enthielt mehr Stöße, als ein Schritt darf.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: the tolerance asks for more or smaller steps than can be taken.</source>
        <translation>%1, angehalten bei %2 s: Die Toleranz verlangt mehr oder kleinere Schritte, als möglich sind.</translation>
    </message>
</context>
<context>
    <name>ui::RunsForm</name>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Step, tolerance</source>
        <translation>Schritt, Toleranz</translation>
    </message>
    <message>
        <source>Step of run %1</source>
        <translation>Schrittweite von Lauf %1</translation>
    </message>
    <message>
        <source>Tolerance of run %1</source>
        <translation>Toleranz von Lauf %1</translation>
    </message>
    <message>
        <source>Method of run %1</source>
        <translation>Verfahren von Lauf %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Lauf %1</translation>
    </message>
    <message>
        <source>addition of a run</source>
        <translation>Hinzufügen eines Laufs</translation>
    </message>
    <message>
        <source>removal of a run</source>
        <translation>Entfernen eines Laufs</translation>
    </message>
    <message>
        <source>change of the method</source>
        <translation>Änderung des Verfahrens</translation>
    </message>
    <message>
        <source>How the run gets from one moment to the next. The error of a method of order p shrinks with the step h like h to the power of p.</source>
        <translation>Wie der Lauf von einem Zeitpunkt zum nächsten kommt. Der Fehler eines Verfahrens der Ordnung p schrumpft mit dem Schritt h wie h hoch p.</translation>
    </message>
    <message>
        <source>Step h in s: how much simulated time the method takes at once. Smaller steps are more exact and cost more.</source>
        <translation>Schritt h in s: wie viel simulierte Zeit das Verfahren auf einmal nimmt. Kleinere Schritte sind genauer und kosten mehr.</translation>
    </message>
    <message>
        <source>Tolerance, without unit: the error the method allows itself in a step, in m, m/s, rad and rad/s. It chooses its steps accordingly.</source>
        <translation>Toleranz, ohne Einheit: der Fehler, den sich das Verfahren in einem Schritt erlaubt, in m, m/s, rad und rad/s. Danach wählt es seine Schritte.</translation>
    </message>
    <message>
        <source>Compute the scene with this method, too</source>
        <translation>Die Szene auch mit diesem Verfahren berechnen</translation>
    </message>
</context>
<context>
    <name>ui::SceneAnnouncer</name>
    <message>
        <source>No weight selected</source>
        <translation>Kein Gewicht gewählt</translation>
    </message>
    <message>
        <source>Weight %1 selected</source>
        <translation>Gewicht %1 gewählt</translation>
    </message>
    <message>
        <source>%1: weight %2, at %3 s</source>
        <comment>an event, such as: Impact on the floor</comment>
        <translation>%1: Gewicht %2, bei %3 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>an event and how many there are</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::SceneCommands</name>
    <message>
        <source>Weights can be moved at the start: press Home, or R for a reset</source>
        <translation>Gewichte können beim Start bewegt werden: Drücken Sie Pos1, oder R zum Zurücksetzen</translation>
    </message>
</context>
<context>
    <name>ui::SceneDrop</name>
    <message>
        <source>What was dropped</source>
        <translation>Das Abgelegte</translation>
    </message>
    <message>
        <source>These are %1 files. Drop one scene file.</source>
        <translation>Das sind %1 Dateien. Legen Sie eine Szenendatei ab.</translation>
    </message>
    <message>
        <source>It is no file on this computer.</source>
        <translation>Das ist keine Datei auf diesem Computer.</translation>
    </message>
    <message>
        <source>It is a folder. Drop a scene file.</source>
        <translation>Das ist ein Ordner. Legen Sie eine Szenendatei ab.</translation>
    </message>
</context>
<context>
    <name>ui::SceneFile</name>
    <message>
        <source>not UTF-8</source>
        <translation>kein UTF-8</translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>kein JSON: %1</translation>
    </message>
    <message>
        <source>larger than 64 MiB</source>
        <translation>größer als 64 MiB</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>not UTF-8 but UTF-16; save it as UTF-8</source>
        <translation>nicht UTF-8, sondern UTF-16; als UTF-8 speichern</translation>
    </message>
    <message>
        <source>it is no file but a pipe or a device</source>
        <translation>das ist keine Datei, sondern eine Pipe oder ein Gerät</translation>
    </message>
</context>
<context>
    <name>ui::SceneFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The scene has changes that are not saved. Save them?</source>
        <translation>Die Szene hat ungespeicherte Änderungen. Möchten Sie sie speichern?</translation>
    </message>
    <message>
        <source>What could not be applied is not saved: %1</source>
        <translation>Was nicht angewandt werden konnte, wird nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>start of a new scene</source>
        <translation>Beginn einer neuen Szene</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Scene not opened</source>
        <translation>Szene nicht geöffnet</translation>
    </message>
    <message>
        <source>%1 was not opened:
%2</source>
        <translation>%1 wurde nicht geöffnet:
%2</translation>
    </message>
    <message>
        <source>opening of %1</source>
        <translation>Öffnen von „%1“</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Scene (*%1 *.json)</source>
        <translation>Szene (*%1 *.json)</translation>
    </message>
    <message>
        <source>Scene not saved</source>
        <translation>Szene nicht gespeichert</translation>
    </message>
    <message>
        <source>%1 was not saved:
%2</source>
        <translation>%1 wurde nicht gespeichert:
%2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>ui::SceneForm</name>
    <message>
        <source>Cut at</source>
        <translation>Schnitt bei</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Fallbeschleunigung</translation>
    </message>
    <message>
        <source>Air density</source>
        <translation>Luftdichte</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Stöße</translation>
    </message>
    <message>
        <source>Restitution of walls</source>
        <translation>Stoßzahl der Wände</translation>
    </message>
    <message>
        <source>Friction of walls</source>
        <translation>Reibungszahl der Wände</translation>
    </message>
    <message>
        <source>Restitution of weights</source>
        <translation>Stoßzahl der Gewichte</translation>
    </message>
    <message>
        <source>Unticked: all ropes are cut by hand, with the Cut button</source>
        <translation>Ohne Häkchen: Alle Seile werden von Hand durchgeschnitten, mit dem Knopf „Schneiden“</translation>
    </message>
    <message>
        <source>Time of the cut</source>
        <translation>Schnittzeit</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>Änderung des Schnitts</translation>
    </message>
    <message>
        <source>How many weights there are, hung up at even intervals. New ones are like the last one.</source>
        <translation>Wie viele Gewichte es gibt, in gleichen Abständen aufgehängt. Neue sind wie das letzte.</translation>
    </message>
    <message>
        <source>Acceleration of free fall g, in m/s². It pulls each weight down with the force m g. On Earth 9.81 m/s².</source>
        <translation>Fallbeschleunigung g, in m/s². Sie zieht jedes Gewicht mit der Kraft m g nach unten. Auf der Erde 9,81 m/s².</translation>
    </message>
    <message>
        <source>Density of the air ρ, in kg/m³. Drag is F = ½ ρ c_d A v² against the velocity, with A = π r². 1.2 kg/m³ at sea level, 0 for vacuum.</source>
        <translation>Dichte der Luft ρ, in kg/m³. Der Luftwiderstand ist F = ½ ρ c_d A v² gegen die Geschwindigkeit, mit A = π r². 1,2 kg/m³ auf Meereshöhe, 0 für Vakuum.</translation>
    </message>
    <message>
        <source>Distance between the walls, in m.</source>
        <translation>Abstand der Wände, in m.</translation>
    </message>
    <message>
        <source>Distance between floor and ceiling, in m.</source>
        <translation>Abstand von Boden und Decke, in m.</translation>
    </message>
    <message>
        <source>Share e of the speed towards a wall, the floor or the ceiling with which a weight leaves it: 1 loses nothing, 0 does not bounce.</source>
        <translation>Anteil e des Tempos auf eine Wand, den Boden oder die Decke zu, mit dem ein Gewicht sie verlässt: 1 verliert nichts, 0 prallt nicht ab.</translation>
    </message>
    <message>
        <source>Friction coefficient μ of walls, floor and ceiling. Friction is at most μ times the force, or the impulse, that presses the weight against them.</source>
        <translation>Reibungszahl μ von Wänden, Boden und Decke. Die Reibung ist höchstens μ mal die Kraft oder der Kraftstoß, die das Gewicht andrücken.</translation>
    </message>
    <message>
        <source>Share e of the speed towards each other with which two weights part after an impact: 1 loses nothing, 0 does not bounce.</source>
        <translation>Anteil e des Tempos aufeinander zu, mit dem sich zwei Gewichte nach einem Stoß trennen: 1 verliert nichts, 0 prallt nicht ab.</translation>
    </message>
    <message>
        <source>Simulated time in s at which all ropes are cut.</source>
        <translation>Simulierte Zeit in s, zu der alle Seile geschnitten werden.</translation>
    </message>
</context>
<context>
    <name>ui::SceneLoading</name>
    <message>
        <source>Opening %1…</source>
        <translation>%1 wird geöffnet…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>ui::SceneMarker</name>
    <message>
        <source>Weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
</context>
<context>
    <name>ui::ScenePicture</name>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 s</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>a picture&apos;s name must end in .png, .svg or .pdf</source>
        <translation>der Name eines Bildes muss auf .png, .svg oder .pdf enden</translation>
    </message>
</context>
<context>
    <name>ui::SceneReader</name>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>muss %1 sein, ist aber %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads version %2</source>
        <translation>%1 ist neuer als dieses Programm, das Version %2 liest</translation>
    </message>
    <message>
        <source>must have either rope or position, got both</source>
        <translation>muss entweder rope oder position haben, hat beides</translation>
    </message>
    <message>
        <source>must have either rope or position, got neither</source>
        <translation>muss entweder rope oder position haben, hat keines</translation>
    </message>
    <message>
        <source>velocity goes with position, got it with rope</source>
        <translation>velocity gehört zu position, steht aber bei rope</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 nimmt eine Toleranz, keine Schrittweite</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 nimmt eine Schrittweite, keine Toleranz</translation>
    </message>
    <message>
        <source>must be like &quot;#e69f00&quot;, got %1</source>
        <translation>muss wie „#e69f00“ sein, ist aber %1</translation>
    </message>
    <message>
        <source>there is no method named %1</source>
        <translation>es gibt kein Verfahren namens %1</translation>
    </message>
</context>
<context>
    <name>ui::SceneToolbar</name>
    <message>
        <source>Scene tools</source>
        <translation>Szenenwerkzeuge</translation>
    </message>
</context>
<context>
    <name>ui::SceneView</name>
    <message>
        <source>at the selected weight only</source>
        <translation>nur am ausgewählten Gewicht</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Gewichtskraft</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>Seil</translation>
    </message>
    <message>
        <source>weights enlarged</source>
        <translation>Gewichte vergrößert</translation>
    </message>
    <message>
        <source>Δx %1, Δy %2</source>
        <translation>Δx %1, Δy %2</translation>
    </message>
    <message>
        <source>Trails shortened: many weights</source>
        <translation>Spuren gekürzt: viele Gewichte</translation>
    </message>
    <message>
        <source>No trails: too many weights</source>
        <translation>Keine Spuren: zu viele Gewichte</translation>
    </message>
    <message>
        <source>OpenGL %1 (%2)</source>
        <translation>OpenGL %1 (%2)</translation>
    </message>
    <message>
        <source>QPainter</source>
        <translation>QPainter</translation>
    </message>
    <message>
        <source>QPainter (OpenGL was lost)</source>
        <translation>QPainter (OpenGL ging verloren)</translation>
    </message>
    <message>
        <source>QPainter (no OpenGL 3.3)</source>
        <translation>QPainter (kein OpenGL 3.3)</translation>
    </message>
    <message>
        <source>QPainter (software OpenGL would be slower)</source>
        <translation>QPainter (Software-OpenGL wäre langsamer)</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>step × %1</source>
        <translation>Schritt × %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stopwatch runs</source>
        <translation>Stoppuhr läuft</translation>
    </message>
    <message>
        <source>stopwatch stands</source>
        <translation>Stoppuhr steht</translation>
    </message>
    <message>
        <source>Hit at %1 s</source>
        <translation>Treffer bei %1 s</translation>
    </message>
    <message>
        <source>Missed by %1 m at %2 s</source>
        <translation>Um %1 m verfehlt bei %2 s</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>The room with its weights and ropes. A click selects a weight, the wheel zooms, dragging moves the view.</source>
        <translation>Der Raum mit seinen Gewichten und Seilen. Ein Klick wählt ein Gewicht, das Rad vergrößert, Ziehen verschiebt die Ansicht.</translation>
    </message>
</context>
<context>
    <name>ui::SeparationChart</name>
    <message>
        <source>Distance between the runs over time</source>
        <translation>Abstand zwischen den Läufen über der Zeit</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, in m, on a logarithmic axis</source>
        <translation>Größter Abstand desselben Gewichts in beiden Läufen, in m, auf logarithmischer Achse</translation>
    </message>
</context>
<context>
    <name>ui::Settings</name>
    <message>
        <source>The settings in %1 were damaged; what could not be read is as at first.</source>
        <translation>Die Einstellungen in %1 waren beschädigt; was nicht zu lesen war, ist wie am Anfang.</translation>
    </message>
    <message>
        <source>Settings are not remembered: nothing can be written to %1</source>
        <translation>Einstellungen werden nicht gemerkt: nach %1 kann nichts geschrieben werden</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPanel</name>
    <message>
        <source>Map</source>
        <translation>Kartieren</translation>
    </message>
    <message>
        <source>Stability map</source>
        <translation>Stabilitätskarte</translation>
    </message>
    <message>
        <source>Method of the map</source>
        <translation>Verfahren der Karte</translation>
    </message>
    <message>
        <source>What the map changes besides the step</source>
        <translation>Was die Karte außer der Schrittweite ändert</translation>
    </message>
    <message>
        <source>Simulated time of each run</source>
        <translation>Simulierte Zeit jedes Laufs</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Step ×</source>
        <translation>Schritt ×</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulierte Zeit</translation>
    </message>
    <message>
        <source>rope length</source>
        <translation>Seillänge</translation>
    </message>
    <message>
        <source>air density</source>
        <translation>Luftdichte</translation>
    </message>
    <message>
        <source>Finds the largest step at which each method stays bounded, that is, makes less energy out of nothing than the scene has to move with.</source>
        <translation>Sucht die größte Schrittweite, bei der jedes Verfahren beschränkt bleibt, also weniger Energie aus dem Nichts erzeugt, als die Szene zum Bewegen hat.</translation>
    </message>
    <message>
        <source>stability</source>
        <translation>stabilität</translation>
    </message>
    <message>
        <source>Export stability map</source>
        <translation>Stabilitätskarte exportieren</translation>
    </message>
    <message>
        <source>For which steps the run keeps its energy, and for which it grows beyond all bounds</source>
        <translation>Für welche Schritte der Lauf seine Energie behält und für welche er über alle Grenzen wächst</translation>
    </message>
    <message>
        <source>How long each run is followed, in s: what grows slowly needs time to show</source>
        <translation>Wie lange jeder Lauf verfolgt wird, in s: was langsam wächst, braucht Zeit, um sich zu zeigen</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>Die Karte als Bild speichern</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPlot</name>
    <message>
        <source>drift under 1 %</source>
        <translation>Drift unter 1 %</translation>
    </message>
    <message>
        <source>under 10 %</source>
        <translation>unter 10 %</translation>
    </message>
    <message>
        <source>up to 100 %</source>
        <translation>bis 100 %</translation>
    </message>
    <message>
        <source>energy more than doubled</source>
        <translation>Energie mehr als verdoppelt</translation>
    </message>
    <message>
        <source>diverged</source>
        <translation>divergiert</translation>
    </message>
    <message>
        <source>%1, each run over %2 s. Drift as a share of the energy the scene has to move with; empty: the weights do not fit the room.</source>
        <translation>%1, jeder Lauf über %2 s. Drift als Anteil der Energie, die die Szene zum Bewegen hat; leer: Die Gewichte passen nicht in den Raum.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Length of the longest rope</source>
        <translation>Länge des längsten Seils</translation>
    </message>
    <message>
        <source>Air density (kg/m³)</source>
        <translation>Luftdichte (kg/m³)</translation>
    </message>
</context>
<context>
    <name>ui::StepPanel</name>
    <message>
        <source>of weight</source>
        <translation>von Gewicht</translation>
    </message>
    <message>
        <source>Weight whose step is shown</source>
        <translation>Gewicht, dessen Schritt gezeigt wird</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Welches Gewicht, von links gezählt</translation>
    </message>
    <message>
        <source>Run whose step is shown</source>
        <translation>Lauf, dessen Schritt gezeigt wird</translation>
    </message>
    <message>
        <source>Part of the step</source>
        <translation>Teil des Schritts</translation>
    </message>
    <message>
        <source>Events divide a step: the method starts anew after each</source>
        <translation>Ereignisse teilen einen Schritt: Das Verfahren beginnt nach jedem neu</translation>
    </message>
    <message>
        <source>The coming step takes long to compute: go on to see it.</source>
        <translation>Der nächste Schritt braucht lange Rechenzeit: Gehen Sie weiter, um ihn zu sehen.</translation>
    </message>
    <message>
        <source>Part %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>There is no step to show.</source>
        <translation>Es gibt keinen Schritt zu zeigen.</translation>
    </message>
    <message>
        <source>The reference takes no slopes: choose another run.</source>
        <translation>Die Referenz hat keine Steigungen: Wählen Sie einen anderen Lauf.</translation>
    </message>
    <message>
        <source>Nothing moves the weight in this step.</source>
        <translation>Nichts bewegt das Gewicht in diesem Schritt.</translation>
    </message>
    <message>
        <source>to come, from %1 s to %2 s</source>
        <translation>kommend, von %1 s bis %2 s</translation>
    </message>
    <message>
        <source>from %1 s to %2 s</source>
        <translation>von %1 s bis %2 s</translation>
    </message>
</context>
<context>
    <name>ui::StepPlot</name>
    <message>
        <source>The step against time</source>
        <translation>Der Schritt gegen die Zeit</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>The exact way, the slopes that the method took, and its end</source>
        <translation>Der exakte Weg, die Steigungen des Verfahrens und sein Ende</translation>
    </message>
</context>
<context>
    <name>ui::StepTable</name>
    <message>
        <source>The step in numbers</source>
        <translation>Der Schritt in Zahlen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Mean slope</source>
        <translation>Mittlere Steigung</translation>
    </message>
    <message>
        <source>End, %1</source>
        <translation>Ende, %1</translation>
    </message>
    <message>
        <source>End, exact</source>
        <translation>Ende, exakt</translation>
    </message>
    <message>
        <source>By a Taylor series from the same start</source>
        <translation>Durch eine Taylorreihe vom selben Start</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>%1 in %2
slope in %3</source>
        <translation>%1 in %2
Steigung in %3</translation>
    </message>
    <message>
        <source>Error
in m</source>
        <translation>Fehler
in m</translation>
    </message>
    <message>
        <source>The slopes that the method took on its way, and where other methods end</source>
        <translation>Die Steigungen, die das Verfahren unterwegs nahm, und wo andere Verfahren enden</translation>
    </message>
    <message>
        <source>Share of the slope in the mean that the step is taken with</source>
        <translation>Anteil der Steigung am Mittel, mit dem der Schritt gemacht wird</translation>
    </message>
    <message>
        <source>%1 at the start and the end, and as a slope how fast it changes</source>
        <translation>%1 am Anfang und am Ende, und als Steigung, wie schnell es sich ändert</translation>
    </message>
    <message>
        <source>Distance of the end from the exact one, in m: the error of this step alone</source>
        <translation>Abstand des Endes vom exakten, in m: der Fehler dieses Schritts allein</translation>
    </message>
</context>
<context>
    <name>ui::StrictReader</name>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>muss %1 sein, ist aber %2</translation>
    </message>
    <message>
        <source>%1 is too large or too small to reckon with</source>
        <translation>%1 ist zu groß oder zu klein, um damit zu rechnen</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>unbekannter Schlüssel %1</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>kommt zweimal vor</translation>
    </message>
    <message>
        <source>must have %1 entries, got %2</source>
        <translation>muss %1 Einträge haben, hat aber %2</translation>
    </message>
    <message>
        <source>must have %1 to %2 entries, got %3</source>
        <translation>muss %1 bis %2 Einträge haben, hat aber %3</translation>
    </message>
</context>
<context>
    <name>ui::TaskRow</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Compute in the background; the same button stops it</source>
        <translation>Im Hintergrund rechnen; derselbe Knopf bricht ab</translation>
    </message>
</context>
<context>
    <name>ui::TimeCommands</name>
    <message>
        <source>Go to a time</source>
        <translation>Gehe zu Zeitpunkt</translation>
    </message>
    <message>
        <source>Simulated time in s</source>
        <translation>Simulierte Zeit in s</translation>
    </message>
</context>
<context>
    <name>ui::Timeline</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>events from %1</source>
        <translation>Ereignisse ab %1</translation>
    </message>
    <message>
        <source>%1 s: %2, weight: %3</source>
        <translation>%1 s: %2, Gewicht: %3</translation>
    </message>
    <message>
        <source>The recording from its start to its end, with marks for events. A click or dragging shows another moment; Home, End and the arrow keys do, too.</source>
        <translation>Die Aufzeichnung vom Anfang bis zum Ende, mit Marken für Ereignisse. Ein Klick oder Ziehen zeigt einen anderen Zeitpunkt; Pos1, Ende und die Pfeiltasten auch.</translation>
    </message>
</context>
<context>
    <name>ui::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>Weights on ropes. Filled ones follow the first method, rings the others. At the start drag a weight to turn its rope; the wheel zooms.</source>
        <translation>Gewichte an Seilen. Gefüllte folgen dem ersten Verfahren, Ringe den anderen. Am Anfang dreht Ziehen an einem Gewicht sein Seil; das Rad vergrößert.</translation>
    </message>
    <message>
        <source>Play and cut</source>
        <translation>Abspielen und schneiden</translation>
    </message>
    <message>
        <source>Space plays and stops. C cuts all ropes, R goes back to the start. Slow motion makes an impact last for seconds.</source>
        <translation>Die Leertaste spielt ab und hält an. C schneidet alle Seile, R geht an den Anfang. In Zeitlupe dauert ein Stoß Sekunden.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Schritt für Schritt</translation>
    </message>
    <message>
        <source>The arrow keys → and ← go by one step, I goes to the next impact. Drag on this line to see any moment again.</source>
        <translation>Die Pfeiltasten → und ← gehen einen Schritt, I geht zum nächsten Stoß. Ziehen auf dieser Linie zeigt jeden Zeitpunkt wieder.</translation>
    </message>
    <message>
        <source>Where the energy goes</source>
        <translation>Wohin die Energie geht</translation>
    </message>
    <message>
        <source>The total should be a flat line. What it climbs or falls was made or lost by the method, not by nature.</source>
        <translation>Die Summe sollte eine waagerechte Linie sein. Was sie steigt oder fällt, hat das Verfahren erzeugt oder verloren, nicht die Natur.</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Verfahren nebeneinander</translation>
    </message>
    <message>
        <source>Up to four methods compute the same scene. Choose them and their steps here, and see who is right. Lessons, at the top right, has scenes to begin with.</source>
        <translation>Bis zu vier Verfahren berechnen dieselbe Szene. Hier werden sie und ihre Schritte gewählt, und man sieht, wer recht hat. Unter Lektionen, oben rechts, gibt es Szenen für den Anfang.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Anfangen</translation>
    </message>
    <message>
        <source>End the tour; the Help menu has it again</source>
        <translation>Den Rundgang beenden; das Menü „Hilfe“ hat ihn wieder</translation>
    </message>
    <message>
        <source>Show the hint before</source>
        <translation>Den vorigen Hinweis zeigen</translation>
    </message>
    <message>
        <source>Go on with the tour, or end it</source>
        <translation>Den Rundgang fortsetzen oder beenden</translation>
    </message>
</context>
<context>
    <name>ui::TradeWindow</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Rechenzeit und Genauigkeit</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>%1 is run %2 now.</source>
        <translation>%1 ist jetzt Lauf %2.</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>What accuracy costs, or how large steps may be</source>
        <translation>Was Genauigkeit kostet oder wie groß Schritte sein dürfen</translation>
    </message>
</context>
<context>
    <name>ui::TradeWords</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>1/%1 s</source>
        <translation>1/%1 s</translation>
    </message>
    <message>
        <source>%1 gets nowhere near at the settings measured</source>
        <translation>%1 kommt mit den gemessenen Einstellungen nicht in die Nähe</translation>
    </message>
    <message>
        <source>%1 needs no more than %2</source>
        <translation>%1 braucht höchstens %2</translation>
    </message>
    <message>
        <source>%1 would need %2 (extrapolated along its order)</source>
        <translation>%1 bräuchte %2 (extrapoliert nach der Ordnung)</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 braucht %2</translation>
    </message>
    <message>
        <source>Measured over %1 s.</source>
        <translation>Gemessen über %1 s.</translation>
    </message>
    <message>
        <source>Measured over the first %1 s of %2 s: later not even the reference solution knows to 10⁻⁶ m where the weights are.</source>
        <translation>Gemessen über die ersten %1 s von %2 s: Später weiß nicht einmal die Referenzlösung auf 10⁻⁶ m genau, wo die Gewichte sind.</translation>
    </message>
    <message>
        <source>%1: no order seen</source>
        <translation>%1: keine Ordnung erkennbar</translation>
    </message>
    <message>
        <source>%1: order %2</source>
        <translation>%1: Ordnung %2</translation>
    </message>
    <message>
        <source>a tolerance of %1 and %2 of computing</source>
        <translation>eine Toleranz von %1 und %2 Rechenzeit</translation>
    </message>
    <message>
        <source>a step of %1 and %2 of computing</source>
        <translation>eine Schrittweite von %1 und %2 Rechenzeit</translation>
    </message>
    <message>
        <source>%1: none that was tried</source>
        <translation>%1: keine der geprüften</translation>
    </message>
    <message>
        <source>%1: any</source>
        <translation>%1: jede</translation>
    </message>
    <message>
        <source>%1: %2 s</source>
        <translation>%1: %2 s</translation>
    </message>
    <message>
        <source>Largest step that stays bounded over %1 s, that is, makes less energy out of nothing than the scene has to move with. %2.</source>
        <translation>Größte Schrittweite, die über %1 s beschränkt bleibt, also weniger Energie aus dem Nichts erzeugt, als die Szene zum Bewegen hat. %2.</translation>
    </message>
    <message>
        <source>No time was simulated.</source>
        <translation>Es wurde keine Zeit simuliert.</translation>
    </message>
    <message>
        <source>To be right within %1 over %2 s: %3.</source>
        <translation>Für einen Fehler bis %1 über %2 s: %3.</translation>
    </message>
</context>
<context>
    <name>ui::TravelBar</name>
    <message>
        <source>How far the computing has come</source>
        <translation>Wie weit die Rechnung gekommen ist</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Anhalten (Esc)</translation>
    </message>
    <message>
        <source>Computing: %1 s</source>
        <translation>Rechnung: %1 s</translation>
    </message>
    <message>
        <source>Computing one step for %1 s</source>
        <translation>Ein Schritt rechnet seit %1 s</translation>
    </message>
</context>
<context>
    <name>ui::UndoCommands</name>
    <message>
        <source>Undone</source>
        <translation>Rückgängig gemacht</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Rückgängig gemacht: %1</translation>
    </message>
    <message>
        <source>Done again</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Wiederholt: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightChart</name>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>θ</source>
        <translation>θ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>ω</source>
        <translation>ω</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>The first %1 of %2 weights</source>
        <translation>Die ersten %1 von %2 Gewichten</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Weight %1</source>
        <translation>Gewicht %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightColumns</name>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Widerstandsbeiwert</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Hangs on</source>
        <translation>Hängt an</translation>
    </message>
    <message>
        <source>Pivot x</source>
        <translation>Aufhängung x</translation>
    </message>
    <message>
        <source>Pivot y</source>
        <translation>Aufhängung y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Startwinkel</translation>
    </message>
    <message>
        <source>Angular velocity</source>
        <translation>Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Velocity x</source>
        <translation>Geschwindigkeit x</translation>
    </message>
    <message>
        <source>Velocity y</source>
        <translation>Geschwindigkeit y</translation>
    </message>
    <message>
        <source>must be %1, got “%2”</source>
        <translation>erlaubt: %1; eingegeben: „%2“</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>like #e69f00, or automatic</source>
        <translation>wie #e69f00, oder automatisch</translation>
    </message>
    <message>
        <source>%1, %2 or %3</source>
        <translation>%1, %2 oder %3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>Seil</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>Stange</translation>
    </message>
    <message>
        <source>Color of the weight, such as #e69f00, or automatic</source>
        <translation>Farbe des Gewichts, etwa #e69f00, oder automatisch</translation>
    </message>
    <message>
        <source>What holds the weight at the start: a rope, a rod, or nothing</source>
        <translation>Was das Gewicht am Anfang hält: ein Seil, ein Stab oder nichts</translation>
    </message>
    <message>
        <source>Where the rope is tied: x from the left wall, y from the floor, in m</source>
        <translation>Wo das Seil befestigt ist: x von der linken Wand, y vom Boden, in m</translation>
    </message>
    <message>
        <source>Angular velocity ω at the start, in °/s, positive counterclockwise</source>
        <translation>Winkelgeschwindigkeit ω am Anfang, in °/s, positiv gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Center of the weight at the start: x from the left wall, y from the floor, in m</source>
        <translation>Mitte des Gewichts am Anfang: x von der linken Wand, y vom Boden, in m</translation>
    </message>
    <message>
        <source>Velocity v at the start: x to the right, y up, in m/s</source>
        <translation>Geschwindigkeit v am Anfang: x nach rechts, y nach oben, in m/s</translation>
    </message>
    <message>
        <source>Mass m, in kg. It does not matter for a swing without air; with air a heavier weight is slowed down less.</source>
        <translation>Masse m, in kg. Ohne Luft ist sie für eine Schwingung gleichgültig; mit Luft wird ein schwereres Gewicht weniger gebremst.</translation>
    </message>
    <message>
        <source>Radius r, in m. Air meets the area A = π r².</source>
        <translation>Radius r, in m. Die Luft trifft auf die Fläche A = π r².</translation>
    </message>
    <message>
        <source>Drag coefficient c_d, without unit: how well the shape is held up by air. 0.47 for a sphere.</source>
        <translation>Widerstandsbeiwert c_d, ohne Einheit: wie sehr die Form von Luft gebremst wird. 0,47 für eine Kugel.</translation>
    </message>
    <message>
        <source>Length of the rope L, in m: from its pivot to the center of the weight. A small swing takes T = 2π √(L/g).</source>
        <translation>Länge des Seils L, in m: vom Aufhängepunkt bis zur Mitte des Gewichts. Eine kleine Schwingung dauert T = 2π √(L/g).</translation>
    </message>
    <message>
        <source>Angle θ of the rope at the start, in degrees from straight down, positive to the right.</source>
        <translation>Winkel θ des Seils am Anfang, in Grad von senkrecht nach unten, positiv nach rechts.</translation>
    </message>
</context>
<context>
    <name>ui::WeightDrag</name>
    <message>
        <source>Angle %1°</source>
        <translation>Winkel %1°</translation>
    </message>
    <message>
        <source>Length %1 m</source>
        <translation>Länge %1 m</translation>
    </message>
    <message>
        <source>x %1 m, y %2 m</source>
        <translation>x %1 m, y %2 m</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>vx %1 m/s, vy %2 m/s</source>
        <translation>vx %1 m/s, vy %2 m/s</translation>
    </message>
</context>
<context>
    <name>ui::WeightMover</name>
    <message>
        <source>change of velocity</source>
        <translation>Änderung der Geschwindigkeit</translation>
    </message>
    <message>
        <source>move of a weight</source>
        <translation>Bewegung eines Gewichts</translation>
    </message>
    <message>
        <source>overlaps another weight</source>
        <translation>überlappt ein anderes Gewicht</translation>
    </message>
    <message>
        <source>outside the room</source>
        <translation>außerhalb des Raums</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>nicht möglich</translation>
    </message>
</context>
<context>
    <name>ui::WeightsClipboard</name>
    <message>
        <source>Weight %1, %2: %3</source>
        <translation>Gewicht %1, %2: %3</translation>
    </message>
    <message>
        <source>a weight on a rope has none, got “%1”</source>
        <translation>gibt es für ein Gewicht am Seil nicht; eingegeben: „%1“</translation>
    </message>
    <message>
        <source>a weight that hangs on nothing has none, got “%1”</source>
        <translation>gibt es für ein Gewicht, das an nichts hängt, nicht; eingegeben: „%1“</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>Line %1 has another number of columns than the first (%2, not %3).</source>
        <translation>Zeile %1 hat eine andere Anzahl von Spalten als die erste (%2 statt %3).</translation>
    </message>
    <message>
        <source>There are too many columns: %1, and from %2 on the table has %3.</source>
        <translation>Es sind zu viele Spalten: %1, und ab %2 hat die Tabelle %3.</translation>
    </message>
    <message>
        <source>There would be more than %1 weights.</source>
        <translation>Es gäbe mehr als %1 Gewichte.</translation>
    </message>
    <message>
        <source>The clipboard holds no text.</source>
        <translation>Die Zwischenablage enthält keinen Text.</translation>
    </message>
    <message>
        <source>There are only headings.</source>
        <translation>Es gibt nur Überschriften.</translation>
    </message>
</context>
<context>
    <name>ui::WeightsForm</name>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Gewicht</translation>
    </message>
    <message>
        <source>Which weight the fields below belong to, counted from the left</source>
        <translation>Zu welchem Gewicht die Felder unten gehören, von links gezählt</translation>
    </message>
    <message>
        <source>Rope</source>
        <translation>Seil</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Startwinkel</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Widerstandsbeiwert</translation>
    </message>
    <message>
        <source>All weights in a table…</source>
        <translation>Alle Gewichte in einer Tabelle…</translation>
    </message>
    <message>
        <source>Change many weights at once, and copy them from and to spreadsheets</source>
        <translation>Viele Gewichte auf einmal ändern und von und nach Tabellenkalkulationen kopieren</translation>
    </message>
</context>
<context>
    <name>ui::WeightsModel</name>
    <message>
        <source>%1 !</source>
        <translation>%1 !</translation>
    </message>
</context>
<context>
    <name>ui::WeightsTable</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Gewichtetabelle</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a weight</source>
        <translation>Ein Gewicht hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Add a copy of each selected weight</source>
        <translation>Eine Kopie jedes ausgewählten Gewichts hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected weights</source>
        <translation>Die ausgewählten Gewichte entfernen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected cells for a spreadsheet</source>
        <translation>Die ausgewählten Zellen für eine Tabellenkalkulation kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Paste cells, from a spreadsheet too, over those from the first selected one on</source>
        <translation>Zellen ab der ersten ausgewählten überschreiben, auch aus einer Tabellenkalkulation</translation>
    </message>
    <message>
        <source>Paste as new</source>
        <translation>Als neue einfügen</translation>
    </message>
    <message>
        <source>Add what was copied as new weights</source>
        <translation>Das Kopierte als neue Gewichte hinzufügen</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Nach unten füllen</translation>
    </message>
    <message>
        <source>Give all selected rows what the first of them holds</source>
        <translation>Allen ausgewählten Zeilen geben, was die erste von ihnen enthält</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>Änderung von „%1“</translation>
    </message>
    <message>
        <source>Nothing was changed. %1</source>
        <translation>Nichts wurde geändert. %1</translation>
    </message>
    <message>
        <source>addition of a weight</source>
        <translation>Hinzufügen eines Gewichts</translation>
    </message>
    <message>
        <source>duplication of weights</source>
        <translation>Duplizieren von Gewichten</translation>
    </message>
    <message>
        <source>removal of weights</source>
        <translation>Entfernen von Gewichten</translation>
    </message>
    <message>
        <source>Rows copied: %1</source>
        <translation>Kopierte Zeilen: %1</translation>
    </message>
    <message>
        <source>pasting</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Rows pasted: %1</source>
        <translation>Eingefügte Zeilen: %1</translation>
    </message>
    <message>
        <source>Rows pasted: %1; new weights: %2</source>
        <translation>Eingefügte Zeilen: %1; neue Gewichte: %2</translation>
    </message>
    <message>
        <source>filling down</source>
        <translation>Füllen nach unten</translation>
    </message>
    <message>
        <source>One row for each weight. Return edits a cell, of all selected rows at once.</source>
        <translation>Eine Zeile für jedes Gewicht. Die Eingabetaste ändert eine Zelle, in allen gewählten Zeilen auf einmal.</translation>
    </message>
</context>
<context>
    <name>ui::WindowFace</name>
    <message>
        <source>Bring them back</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Undo the change</source>
        <translation>Änderung rückgängig machen</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a crash: %1</source>
        <translation>Ungespeicherte Änderungen können nicht für einen Absturz gesichert werden: %1</translation>
    </message>
    <message>
        <source>&amp;Colors</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Like the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>Dun&amp;kel</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Te&amp;xtgröße</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Normal</translation>
    </message>
    <message>
        <source>&amp;Large</source>
        <translation>&amp;Groß</translation>
    </message>
    <message>
        <source>&amp;Very large</source>
        <translation>&amp;Sehr groß</translation>
    </message>
    <message>
        <source>&amp;Drawn by</source>
        <translation>Gezei&amp;chnet mit</translation>
    </message>
    <message>
        <source>&amp;Automatic choice</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>&amp;OpenGL</source>
        <translation>&amp;OpenGL</translation>
    </message>
    <message>
        <source>&amp;QPainter</source>
        <translation>&amp;QPainter</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Sp&amp;rache</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>Nicht angewandt: %1</translation>
    </message>
    <message>
        <source>%1[*] – Angry Cuts</source>
        <translation>%1[*] – Angry Cuts</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Neue Szene</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Gezeichnet mit %1</translation>
    </message>
</context>
<context>
    <name>ui::WindowPanels</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Gewichte</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Inside a step</source>
        <translation>Einzelschritt</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Gewichtetabelle</translation>
    </message>
</context>
<context>
    <name>ui::WorkPrecisionPlot</name>
    <message>
        <source>slope %1</source>
        <translation>Steigung %1</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Rechenzeit pro simulierter Sekunde</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schrittweite</translation>
    </message>
    <message>
        <source>Largest position error</source>
        <translation>Größter Ortsfehler</translation>
    </message>
</context>
</TS>
