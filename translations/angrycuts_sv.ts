<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sv_SE" sourcelanguage="en_US">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Mapp</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Mapp</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Enhet</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Genväg</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Okänd</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Markera allt</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>Stega &amp;upp</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>Stega &amp;ned</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>Okänt alternativ ”%1”.</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>Okända alternativ: %1.</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>Värde saknas efter ”%1”.</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>Oväntat värde efter ”%1”.</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Leta i:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Mapp:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Fil&amp;namn:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Filtyp:</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Hitta mapp</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Bakåt</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Gå bakåt</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Framåt</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Gå framåt</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Överordnad mapp</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Gå till överordnad mapp</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Skapa ny mapp</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Skapa en ny mapp</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Ny mapp</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Ny mapp</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Listvy</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Byt till listvy</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Detaljerad vy</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Byt till detaljerad vy</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Sidofält</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Platser och bokmärken</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Filer</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Mappar</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Senaste platser</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öppna</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Spara som</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Välj</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Byt namn</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Ta bort</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Visa </translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>Visa &amp;dolda filer</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alla filer (*)</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 finns redan.
Vill du ersätta den?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>”%1” är skrivskyddad.
Vill du ta bort den ändå?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>Vill du verkligen ta bort ”%1”?</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>Mappen kunde inte tas bort.</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Filen hittades inte.
Kontrollera att namnet är rätt.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Mappen hittades inte.
Kontrollera att namnet är rätt.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Namn</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Storlek</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Slag</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Ändrad</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Dator</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Min dator</translation>
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
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Avbryt</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Stäng</translation>
    </message>
    <message>
        <source>Close without Saving</source>
        <translation>Stäng utan att spara</translation>
    </message>
</context>
<context>
    <name>QIODevice</name>
    <message>
        <source>Permission denied</source>
        <translation>Åtkomst nekad</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>För många öppna filer</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Filen eller mappen finns inte</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Enheten är full</translation>
    </message>
    <message>
        <source>file to open is a directory</source>
        <translation>det är en mapp, ingen fil</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Klipp &amp;ut</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiera</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>K&amp;listra in</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Markera allt</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>Visa detaljer…</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Dölj detaljer…</translation>
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
        <translation>Ja till &amp;alla</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nej</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;ej till alla</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spara</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Spara alla</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öppna</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Försök igen</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorera</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Kasta</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Verkställ</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Återställ standard</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hjälp</translation>
    </message>
</context>
<context>
    <name>QSaveFile</name>
    <message>
        <source>Existing file %1 is not writable</source>
        <translation>Filen %1 finns och är skrivskyddad</translation>
    </message>
    <message>
        <source>Filename refers to a directory</source>
        <translation>Namnet tillhör en mapp</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Rulla hit</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Vänsterkanten</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Början</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Högerkanten</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Slutet</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>En sida åt vänster</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>En sida upp</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>En sida åt höger</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>En sida ned</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Rulla åt vänster</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Rulla upp</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Rulla åt höger</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Rulla ned</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Skift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Mellanslag</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Vänsterpil</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Högerpil</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Uppil</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nedpil</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>PgUp</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgDn</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page Down</translation>
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
        <translation>Insert</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insert</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tabb</translation>
    </message>
    <message>
        <source>Backtab</source>
        <translation>Skift+Tabb</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Retur</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backsteg</translation>
    </message>
    <message>
        <source>Media Play</source>
        <translation>Spela</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Rulla åt vänster</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Rulla åt höger</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Klipp &amp;ut</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopiera</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>Kopiera &amp;länkadress</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>K&amp;listra in</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Markera allt</translation>
    </message>
</context>
<context>
    <name>app::Arguments</name>
    <message>
        <source>stands twice</source>
        <translation>förekommer två gånger</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>oväntat argument ”%1”</translation>
    </message>
    <message>
        <source>must be a number, got &quot;%1&quot;</source>
        <translation>måste vara ett tal, är ”%1”</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>måste vara ett namn</translation>
    </message>
</context>
<context>
    <name>app::CsvOutput</name>
    <message>
        <source>standard output</source>
        <translation>standard ut</translation>
    </message>
</context>
<context>
    <name>app::Demonstration</name>
    <message>
        <source>every method diverged before %1 s</source>
        <translation>alla metoder divergerade före %1 s</translation>
    </message>
    <message>
        <source>There is no display for the window, so &quot;%1&quot; was simulated for %2 s.
%3: energy with %4
%5: where every weight is, with %6
%7: the scene at %8 s
</source>
        <translation>Det finns ingen skärm för fönstret, så ”%1” simulerades i %2 s.
%3: energi med %4
%5: var varje vikt är, med %6
%7: scenen vid %8 s
</translation>
    </message>
    <message>
        <source> and </source>
        <translation> och </translation>
    </message>
</context>
<context>
    <name>app::EnergyHistory</name>
    <message>
        <source>Time in s; energies in J: kinetic, potential, lost to air, to impacts, to ropes, to friction; numerical drift
</source>
        <translation>Tid i s; energier i J: rörelseenergi, lägesenergi, förlust genom luft, stötar, rep, friktion; numerisk drift
</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tid</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>rörelse</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>läge</translation>
    </message>
    <message>
        <source>air</source>
        <translation>luft</translation>
    </message>
    <message>
        <source>impacts</source>
        <translation>stötar</translation>
    </message>
    <message>
        <source>ropes</source>
        <translation>rep</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>friktion</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>drift</translation>
    </message>
</context>
<context>
    <name>app::ExitStatus</name>
    <message>
        <source>standard output: %1</source>
        <translation>standard ut: %1</translation>
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
        <translation>Användning:
  angrycuts [SCEN]                      öppna fönstret
  angrycuts scenes [--export MAPP]      lista de inbyggda scenerna, eller skriv dem som filer
  angrycuts simulate SCEN [flaggor]     kör utan fönster
  angrycuts measure SCEN [flaggor]      mät snabbhet mot noggrannhet
  angrycuts --help, --version

En SCEN är en fil eller namnet på en inbyggd scen. Där det inte finns någon skärm
simulerar angrycuts [SCEN] scenen med var och en av dess metoder och skriver resultatet
i den aktuella mappen.

Flaggor för simulate:
  --method NAMN          %1 (rk4)
  --step SEKUNDER        metodens steg, från 1e-7 till 10 (1/60)
  --tolerance X          i stället för steg för dopri5, från 1e-14 till 1 (1e-9)
  --until SEKUNDER       simulerad tid att nå, från 0 till 1e6 (10)
  --cut SEKUNDER|never   när alla rep klipps (som scenen anger)
  --sample SEKUNDER      tid mellan rader, från 1e-7 till 1e6 (0.1)
  --trajectory FIL       var varje vikt är, som CSV; - är standard ut
  --energy FIL           var energin är, som CSV; - är standard ut
  --events FIL           vad som hände, som CSV; - är standard ut
  --chart FIL            energidiagrammet som .png, .svg eller .pdf
Utan någon av de fyra filerna skrivs en kort tabell ut.

Flaggor för measure, som provar alla metoder med många steg:
  --until SEKUNDER       simulerad tid att mäta över, från 0 till 1e6 (10)
  --cut SEKUNDER|never   när alla rep klipps (som scenen anger)
  --csv FIL              alla siffror, som CSV; - är standard ut
  --chart FIL            fel mot kostnad som .png, .svg eller .pdf
Utan någon av filerna skrivs en kort tabell ut.

Slutstatus: 0; 2 där anropet eller scenen avvisas; 3 där talen, eller händelserna eller
stegen inom ett steg, gick överstyr; 1 för allt annat, till exempel en full disk.
</translation>
    </message>
</context>
<context>
    <name>app::MeasureTable</name>
    <message>
        <source>at most</source>
        <translation>högst</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <translation>extrapolerat</translation>
    </message>
    <message>
        <source>method</source>
        <translation>metod</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordning</translation>
    </message>
    <message>
        <source>least error</source>
        <translation>minsta fel</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>inställning</translation>
    </message>
    <message>
        <source>ns per s</source>
        <translation>ns per s</translation>
    </message>
    <message>
        <source>Order: the power of the step that the position error falls with. Setting (step in s, or tolerance)
and cost (ns of computing per simulated second): to be right within 1e-6 m.

</source>
        <translation>Ordning: den potens av steget som lägesfelet avtar med. Inställning (steg i s, eller tolerans)
och kostnad (ns beräkning per simulerad sekund): för ett fel på högst 1e-6 m.

</translation>
    </message>
</context>
<context>
    <name>app::Options</name>
    <message>
        <source>%1 is used twice</source>
        <translation>%1 används två gånger</translation>
    </message>
    <message>
        <source>must end in .png, .svg or .pdf, got &quot;%1&quot;</source>
        <translation>måste sluta på .png, .svg eller .pdf, är ”%1”</translation>
    </message>
    <message>
        <source>%1: a scene must be named</source>
        <translation>%1: en scen måste anges</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;</source>
        <translation>okänt kommando ”%1”</translation>
    </message>
    <message>
        <source>must be one of %1, got &quot;%2&quot;</source>
        <translation>måste vara en av %1, är ”%2”</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 tar en tolerans, inget steg</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 tar ett steg, ingen tolerans</translation>
    </message>
</context>
<context>
    <name>app::ProgressLine</name>
    <message>
        <source>Measuring: %1 %</source>
        <translation>Mäter: %1 %</translation>
    </message>
</context>
<context>
    <name>app::ScenesCommand</name>
    <message>
        <source>%1: the folder cannot be made</source>
        <translation>%1: mappen kan inte skapas</translation>
    </message>
</context>
<context>
    <name>app::SimulateCommand</name>
    <message>
        <source>a larger --tolerance may help</source>
        <translation>ett större --tolerance kan hjälpa</translation>
    </message>
    <message>
        <source>a smaller --tolerance may help</source>
        <translation>ett mindre --tolerance kan hjälpa</translation>
    </message>
    <message>
        <source>a smaller --step may help</source>
        <translation>ett mindre --step kan hjälpa</translation>
    </message>
    <message>
        <source>--step %1 works</source>
        <translation>--step %1 fungerar</translation>
    </message>
    <message>
        <source>the numbers stopped being finite</source>
        <translation>talen är inte längre ändliga</translation>
    </message>
    <message>
        <source>the next step holds more events than can be followed</source>
        <translation>nästa steg har fler händelser än som kan följas</translation>
    </message>
    <message>
        <source>the tolerance asks for more or smaller steps than can be taken</source>
        <translation>toleransen kräver fler eller mindre steg än som kan tas</translation>
    </message>
    <message>
        <source>diverged at %1 s: %2; %3</source>
        <translation>divergerade vid %1 s: %2; %3</translation>
    </message>
</context>
<context>
    <name>app::main</name>
    <message>
        <source>the window cannot be opened: %1</source>
        <translation>fönstret kan inte öppnas: %1</translation>
    </message>
    <message>
        <source>no display answers (%1)</source>
        <translation>ingen skärm svarar (%1)</translation>
    </message>
</context>
<context>
    <name>ui::AccuracyPanel</name>
    <message>
        <source>Measure</source>
        <translation>Mät</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulerad tid</translation>
    </message>
    <message>
        <source>Error against cost</source>
        <translation>Fel mot kostnad</translation>
    </message>
    <message>
        <source>Error against step</source>
        <translation>Fel mot steg</translation>
    </message>
    <message>
        <source>What the chart shows</source>
        <translation>Vad diagrammet visar</translation>
    </message>
    <message>
        <source>Right within</source>
        <translation>Fel högst</translation>
    </message>
    <message>
        <source>Error against cost or step</source>
        <translation>Fel mot kostnad eller steg</translation>
    </message>
    <message>
        <source>Click a point to open it as a run</source>
        <translation>Klicka på en punkt för att öppna den som körning</translation>
    </message>
    <message>
        <source>Measures every method at steps from 1/8 to 1/8192 s: how far the weights are from where they really are, and what that costs. Takes some seconds.</source>
        <translation>Mäter varje metod med steg från 1/8 till 1/8192 s: hur långt vikterna är från sitt verkliga läge, och vad det kostar. Tar några sekunder.</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>noggrannhet</translation>
    </message>
    <message>
        <source>How long each run is followed, in s; errors are compared at its end</source>
        <translation>Hur länge varje körning följs, i s; felen jämförs vid dess slut</translation>
    </message>
    <message>
        <source>Cost is counted in slope evaluations, which the time of computing goes with</source>
        <translation>Kostnaden räknas i lutningsberäkningar, som räknetiden följer</translation>
    </message>
    <message>
        <source>Largest distance from the true place that is accepted, in m: which method reaches it at the lowest cost?</source>
        <translation>Största avstånd från rätt plats som godtas, i m: vilken metod når det till lägsta kostnad?</translation>
    </message>
</context>
<context>
    <name>ui::BuiltInScenes</name>
    <message>
        <source>no file or built-in scene of that name</source>
        <translation>ingen fil eller inbyggd scen med det namnet</translation>
    </message>
</context>
<context>
    <name>ui::ChartFile</name>
    <message>
        <source>a chart&apos;s file ends in .png, .svg or .pdf</source>
        <translation>en diagramfil slutar på .png, .svg eller .pdf</translation>
    </message>
</context>
<context>
    <name>ui::ChartKind</name>
    <message>
        <source>Energy</source>
        <translation>Energi</translation>
    </message>
    <message>
        <source>Energies over time</source>
        <translation>Energier över tiden</translation>
    </message>
    <message>
        <source>Ledger</source>
        <translation>Balans</translation>
    </message>
    <message>
        <source>Where the energy is and went, stacked</source>
        <translation>Energibalans: var energin är och vart den tog vägen, staplat</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fas</translation>
    </message>
    <message>
        <source>Phase portrait: angular velocity against angle</source>
        <translation>Fasporträtt: vinkelhastighet mot vinkel</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Banor</translation>
    </message>
    <message>
        <source>Paths of the weights: y against x</source>
        <translation>Vikternas banor: y mot x</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Height above the floor over time</source>
        <translation>Höjd över golvet över tiden</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Fart</translation>
    </message>
    <message>
        <source>Speed over time</source>
        <translation>Fart över tiden</translation>
    </message>
</context>
<context>
    <name>ui::ChartOverlay</name>
    <message>
        <source>… and %1 more</source>
        <translation>… och %1 till</translation>
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
        <translation>Sidbredd</translation>
    </message>
    <message>
        <source>Half the page width</source>
        <translation>Halva sidbredden</translation>
    </message>
    <message>
        <source>Slide, 16:9</source>
        <translation>Bildspel, 16:9</translation>
    </message>
    <message>
        <source>Poster, A3</source>
        <translation>Affisch, A3</translation>
    </message>
    <message>
        <source>Size of the chart</source>
        <translation>Diagrammets storlek</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Egen storlek</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;För</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Bredd</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höjd</translation>
    </message>
    <message>
        <source>Sizes that are often wanted</source>
        <translation>Storlekar som ofta behövs</translation>
    </message>
    <message>
        <source>Width of the chart on paper, in mm</source>
        <translation>Diagrammets bredd på papper, i mm</translation>
    </message>
    <message>
        <source>Height of the chart on paper, in mm</source>
        <translation>Diagrammets höjd på papper, i mm</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Syfte</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
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
        <translation>Tid</translation>
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
        <translation>Ett klick går till en tidpunkt. Hjulet, plus och minus zoomar, liksom att dra upp en ruta; Alt och piltangenterna flyttar diagrammet, 0 visar hela.</translation>
    </message>
</context>
<context>
    <name>ui::ChartsPanel</name>
    <message>
        <source>Kind of chart</source>
        <translation>Diagramtyp</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Alla vikter</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Vikt </translation>
    </message>
    <message>
        <source>Weight in the chart</source>
        <translation>Vikt i diagrammet</translation>
    </message>
    <message>
        <source>Weight in the chart, counted from the left; 0: all</source>
        <translation>Vikt i diagrammet, räknat från vänster; 0: alla</translation>
    </message>
    <message>
        <source>Runs in the chart</source>
        <translation>Körningar i diagrammet</translation>
    </message>
    <message>
        <source>Chart menu</source>
        <translation>Diagrammeny</translation>
    </message>
    <message>
        <source>Zoom, copy, export, hide curves</source>
        <translation>Zooma, kopiera, exportera, dölj kurvor</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>K&amp;urvor</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Alla</translation>
    </message>
    <message>
        <source>What the chart shows against what</source>
        <translation>Vad diagrammet visar mot vad</translation>
    </message>
</context>
<context>
    <name>ui::Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Ny</translation>
    </message>
    <message>
        <source>Start with one weight in an empty room</source>
        <translation>Börja med en vikt i ett tomt rum</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öppna…</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>Öppna en scenfil</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Lektioner…</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektioner</translation>
    </message>
    <message>
        <source>Choose one of the built-in scenes by its picture</source>
        <translation>Välj en av de inbyggda scenerna efter dess bild</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spara</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Spara scenen</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Spara so&amp;m…</translation>
    </message>
    <message>
        <source>Save the scene in another file</source>
        <translation>Spara scenen i en annan fil</translation>
    </message>
    <message>
        <source>&amp;Export chart…</source>
        <translation>Exportera &amp;diagram…</translation>
    </message>
    <message>
        <source>Save the chart as a PNG, SVG or PDF picture</source>
        <translation>Spara diagrammet som PNG-, SVG- eller PDF-bild</translation>
    </message>
    <message>
        <source>Export &amp;picture of the scene…</source>
        <translation>Exportera &amp;bild av scenen…</translation>
    </message>
    <message>
        <source>Save what is shown as a PNG, SVG or PDF picture</source>
        <translation>Spara det som visas som PNG-, SVG- eller PDF-bild</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Avsluta</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>Take back the last change of the scene</source>
        <translation>Ta tillbaka den senaste ändringen av scenen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>Make the change again that was taken back last</source>
        <translation>Gör om den ändring som senast togs tillbaka</translation>
    </message>
    <message>
        <source>&amp;Weights table</source>
        <translation>&amp;Vikttabell</translation>
    </message>
    <message>
        <source>All weights in a table, to be changed many at once</source>
        <translation>Alla vikter i en tabell, där många kan ändras på en gång</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>S&amp;pela upp</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Spela</translation>
    </message>
    <message>
        <source>Let time pass, or stop it</source>
        <translation>Låt tiden gå, eller stoppa den</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Stega</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stega</translation>
    </message>
    <message>
        <source>Take one integration step of the first run</source>
        <translation>Ta ett integrationssteg i första körningen</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Stega till&amp;baka</translation>
    </message>
    <message>
        <source>Go back by one integration step of the first run</source>
        <translation>Gå tillbaka ett integrationssteg i första körningen</translation>
    </message>
    <message>
        <source>Step one &amp;frame</source>
        <translation>Stega en bild&amp;ruta</translation>
    </message>
    <message>
        <source>Go on by 1/60 s, times the speed</source>
        <translation>Gå framåt 1/60 s, gånger tempot</translation>
    </message>
    <message>
        <source>Step a f&amp;rame back</source>
        <translation>Stega en bildru&amp;ta tillbaka</translation>
    </message>
    <message>
        <source>Go back by 1/60 s, times the speed</source>
        <translation>Gå tillbaka 1/60 s, gånger tempot</translation>
    </message>
    <message>
        <source>&amp;Cut the ropes</source>
        <translation>&amp;Klipp repen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Klipp</translation>
    </message>
    <message>
        <source>Cut all ropes now</source>
        <translation>Klipp alla rep nu</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Återställ</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Återställ</translation>
    </message>
    <message>
        <source>Go back to the start</source>
        <translation>Gå tillbaka till starten</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Långsammare</translation>
    </message>
    <message>
        <source>Halve the speed</source>
        <translation>Halvera tempot</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>S&amp;nabbare</translation>
    </message>
    <message>
        <source>Double the speed</source>
        <translation>Dubbla tempot</translation>
    </message>
    <message>
        <source>Split &amp;views</source>
        <translation>&amp;Delade vyer</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Dela</translation>
    </message>
    <message>
        <source>Give each run a view of its own</source>
        <translation>Ge varje körning en egen vy</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>&amp;Nästa händelse</translation>
    </message>
    <message>
        <source>Go to the next event of any kind</source>
        <translation>Gå till nästa händelse, vilken som helst</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>&amp;Föregående händelse</translation>
    </message>
    <message>
        <source>Go back to the event before</source>
        <translation>Gå tillbaka till händelsen före</translation>
    </message>
    <message>
        <source>Next &amp;impact</source>
        <translation>Nästa &amp;stöt</translation>
    </message>
    <message>
        <source>Go on until something is hit</source>
        <translation>Fortsätt tills något träffas</translation>
    </message>
    <message>
        <source>Previous i&amp;mpact</source>
        <translation>Föregående s&amp;töt</translation>
    </message>
    <message>
        <source>Go back to the impact before</source>
        <translation>Gå tillbaka till stöten före</translation>
    </message>
    <message>
        <source>Next &amp;turning point</source>
        <translation>Nästa &amp;vändläge</translation>
    </message>
    <message>
        <source>Go on until a weight turns round on its rope</source>
        <translation>Fortsätt tills en vikt vänder på sitt rep</translation>
    </message>
    <message>
        <source>Previous t&amp;urning point</source>
        <translation>Föregående vän&amp;dläge</translation>
    </message>
    <message>
        <source>Go back to the turning point before</source>
        <translation>Gå tillbaka till vändläget före</translation>
    </message>
    <message>
        <source>Next &amp;cut</source>
        <translation>Nästa &amp;klipp</translation>
    </message>
    <message>
        <source>Go on until ropes are cut</source>
        <translation>Fortsätt tills rep klipps</translation>
    </message>
    <message>
        <source>Previous cu&amp;t</source>
        <translation>Föregående k&amp;lipp</translation>
    </message>
    <message>
        <source>Go back to the cut before</source>
        <translation>Gå tillbaka till klippet före</translation>
    </message>
    <message>
        <source>&amp;Start of the recording</source>
        <translation>&amp;Början av inspelningen</translation>
    </message>
    <message>
        <source>Show the start again; what is recorded stays</source>
        <translation>Visa starten igen; det inspelade finns kvar</translation>
    </message>
    <message>
        <source>&amp;End of the recording</source>
        <translation>Sl&amp;utet av inspelningen</translation>
    </message>
    <message>
        <source>Show the last moment that is computed</source>
        <translation>Visa den sista tidpunkt som är beräknad</translation>
    </message>
    <message>
        <source>&amp;Go to a time…</source>
        <translation>&amp;Gå till en tidpunkt…</translation>
    </message>
    <message>
        <source>Show any moment, and compute it first where needed</source>
        <translation>Visa vilken tidpunkt som helst, och beräkna den först vid behov</translation>
    </message>
    <message>
        <source>Stop &amp;on the way</source>
        <translation>St&amp;anna på vägen</translation>
    </message>
    <message>
        <source>Stay at the moment that the computing has come to</source>
        <translation>Stanna vid den tidpunkt som beräkningen har nått</translation>
    </message>
    <message>
        <source>Speed and &amp;accuracy…</source>
        <translation>Snabbhet och n&amp;oggrannhet…</translation>
    </message>
    <message>
        <source>Measure what accuracy costs, and how large steps may be</source>
        <translation>Mät vad noggrannhet kostar, och hur stora steg får vara</translation>
    </message>
    <message>
        <source>&amp;When to cut?…</source>
        <translation>När ska &amp;man klippa?…</translation>
    </message>
    <message>
        <source>Find the moments to cut at that hit the target</source>
        <translation>Hitta de klipptider som träffar målet</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>&amp;Spår</translation>
    </message>
    <message>
        <source>Show where the weights have just been</source>
        <translation>Visa var vikterna nyss har varit</translation>
    </message>
    <message>
        <source>V&amp;elocities</source>
        <translation>&amp;Hastigheter</translation>
    </message>
    <message>
        <source>Show how fast the weights move, and where to, as arrows</source>
        <translation>Visa hur fort vikterna rör sig, och vart, som pilar</translation>
    </message>
    <message>
        <source>Fo&amp;rces</source>
        <translation>&amp;Krafter</translation>
    </message>
    <message>
        <source>Show gravity, air drag and the pull of the rope as arrows</source>
        <translation>Visa tyngdkraft, luftmotstånd och repets spännkraft som pilar</translation>
    </message>
    <message>
        <source>Te&amp;nsions</source>
        <translation>Spännkra&amp;fter</translation>
    </message>
    <message>
        <source>Show in newtons how hard each rope pulls</source>
        <translation>Visa i newton hur hårt varje rep drar</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Linjal</translation>
    </message>
    <message>
        <source>Measure a length in the scene</source>
        <translation>Mät en längd i scenen</translation>
    </message>
    <message>
        <source>&amp;Protractor</source>
        <translation>&amp;Gradskiva</translation>
    </message>
    <message>
        <source>Measure an angle in the scene</source>
        <translation>Mät en vinkel i scenen</translation>
    </message>
    <message>
        <source>&amp;Stopwatch</source>
        <translation>&amp;Stoppur</translation>
    </message>
    <message>
        <source>Measure simulated time</source>
        <translation>Mät simulerad tid</translation>
    </message>
    <message>
        <source>S&amp;tart or stop the stopwatch</source>
        <translation>S&amp;tarta eller stoppa stoppuret</translation>
    </message>
    <message>
        <source>Start the stopwatch at the moment shown, or stop it</source>
        <translation>Starta stoppuret vid den visade tidpunkten, eller stoppa det</translation>
    </message>
    <message>
        <source>Stopwatch to &amp;zero</source>
        <translation>Nollställ st&amp;oppuret</translation>
    </message>
    <message>
        <source>Set the stopwatch back to zero</source>
        <translation>Ställ tillbaka stoppuret till noll</translation>
    </message>
    <message>
        <source>&amp;Next handle</source>
        <translation>&amp;Nästa handtag</translation>
    </message>
    <message>
        <source>Choose what Alt and the arrow keys move: an end of the ruler, an arm of the protractor …</source>
        <translation>Välj vad Alt och piltangenterna flyttar: en ände av linjalen, en arm av gradskivan …</translation>
    </message>
    <message>
        <source>Tar&amp;get</source>
        <translation>Må&amp;l</translation>
    </message>
    <message>
        <source>Show a target on the floor; drag it to where it shall be</source>
        <translation>Visa ett mål på golvet; dra det dit det ska vara</translation>
    </message>
    <message>
        <source>&amp;Lesson text</source>
        <translation>Lektionst&amp;ext</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Show what to look for and what to try, or hide it</source>
        <translation>Visa vad man ska titta efter och prova, eller dölj det</translation>
    </message>
    <message>
        <source>&amp;Fit the room</source>
        <translation>Visa hela r&amp;ummet</translation>
    </message>
    <message>
        <source>Show the whole room</source>
        <translation>Visa hela rummet</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zooma &amp;in</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zooma u&amp;t</translation>
    </message>
    <message>
        <source>&amp;Next weight</source>
        <translation>&amp;Nästa vikt</translation>
    </message>
    <message>
        <source>Select the next weight</source>
        <translation>Välj nästa vikt</translation>
    </message>
    <message>
        <source>&amp;Previous weight</source>
        <translation>&amp;Föregående vikt</translation>
    </message>
    <message>
        <source>Select the weight before</source>
        <translation>Välj vikten före</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>&amp;Avmarkera</translation>
    </message>
    <message>
        <source>Select no weight and no handle any more</source>
        <translation>Välj inte längre någon vikt eller något handtag</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Flytta åt &amp;vänster</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the left, or move the weight or handle</source>
        <translation>Vrid den valda viktens rep åt vänster, eller flytta vikten eller handtaget</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>Flytta åt &amp;höger</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the right, or move the weight or handle</source>
        <translation>Vrid den valda viktens rep åt höger, eller flytta vikten eller handtaget</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Flytta &amp;uppåt</translation>
    </message>
    <message>
        <source>Shorten the rope of the selected weight, or move the weight or handle up</source>
        <translation>Förkorta den valda viktens rep, eller flytta vikten eller handtaget uppåt</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Flytta ne&amp;dåt</translation>
    </message>
    <message>
        <source>Lengthen the rope of the selected weight, or move the weight or handle down</source>
        <translation>Förläng den valda viktens rep, eller flytta vikten eller handtaget nedåt</translation>
    </message>
    <message>
        <source>Faster l&amp;eft</source>
        <translation>Snabbare åt vän&amp;ster</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the left</source>
        <translation>Öka den valda viktens hastighet åt vänster</translation>
    </message>
    <message>
        <source>Faster r&amp;ight</source>
        <translation>Snabbare åt hö&amp;ger</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the right</source>
        <translation>Öka den valda viktens hastighet åt höger</translation>
    </message>
    <message>
        <source>&amp;Faster up</source>
        <translation>Snabbare u&amp;ppåt</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight upwards</source>
        <translation>Öka den valda viktens hastighet uppåt</translation>
    </message>
    <message>
        <source>Fa&amp;ster down</source>
        <translation>Snabbare nedå&amp;t</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight downwards</source>
        <translation>Öka den valda viktens hastighet nedåt</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>Prese&amp;ntera</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Presentera</translation>
    </message>
    <message>
        <source>Fill the screen with the scene and one chart, in large type</source>
        <translation>Fyll skärmen med scenen och ett diagram, med stor text</translation>
    </message>
    <message>
        <source>&amp;Next chart</source>
        <translation>&amp;Nästa diagram</translation>
    </message>
    <message>
        <source>Show the next kind of chart</source>
        <translation>Visa nästa sorts diagram</translation>
    </message>
    <message>
        <source>&amp;Previous chart</source>
        <translation>&amp;Föregående diagram</translation>
    </message>
    <message>
        <source>Show the previous kind of chart</source>
        <translation>Visa föregående sorts diagram</translation>
    </message>
    <message>
        <source>&amp;Whole chart</source>
        <translation>&amp;Hela diagrammet</translation>
    </message>
    <message>
        <source>Show all of the chart again after zooming</source>
        <translation>Visa hela diagrammet igen efter zoomning</translation>
    </message>
    <message>
        <source>&amp;Copy chart</source>
        <translation>&amp;Kopiera diagram</translation>
    </message>
    <message>
        <source>Copy the chart as a picture for paper</source>
        <translation>Kopiera diagrammet som bild för papper</translation>
    </message>
    <message>
        <source>Copy chart &amp;data</source>
        <translation>Kopiera diagramda&amp;ta</translation>
    </message>
    <message>
        <source>Copy the chart&apos;s curves as a table for a spreadsheet</source>
        <translation>Kopiera diagrammets kurvor som tabell för ett kalkylprogram</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tangenter</translation>
    </message>
    <message>
        <source>List all keys</source>
        <translation>Lista alla tangenter</translation>
    </message>
    <message>
        <source>&amp;About Angry Cuts</source>
        <translation>&amp;Om Angry Cuts</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Paus</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Paus</translation>
    </message>
    <message>
        <source>&amp;Teacher&apos;s sheet</source>
        <translation>&amp;Lärarblad</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blad</translation>
    </message>
    <message>
        <source>Goal, steps, questions and expected figures of this lesson, to be printed</source>
        <translation>Lektionens mål, steg, frågor och väntade siffror, att skriva ut</translation>
    </message>
    <message>
        <source>Quick &amp;guide</source>
        <translation>&amp;Snabbguide</translation>
    </message>
    <message>
        <source>Explain the window in a few pages</source>
        <translation>Förklara fönstret på några sidor</translation>
    </message>
    <message>
        <source>The &amp;model</source>
        <translation>&amp;Modellen</translation>
    </message>
    <message>
        <source>Show the equations that are computed, and why</source>
        <translation>Visa ekvationerna som beräknas, och varför</translation>
    </message>
    <message>
        <source>T&amp;our of the window</source>
        <translation>&amp;Rundtur i fönstret</translation>
    </message>
    <message>
        <source>Point out the five most important parts of the window</source>
        <translation>Peka ut fönstrets fem viktigaste delar</translation>
    </message>
</context>
<context>
    <name>ui::ComparisonPanel</name>
    <message>
        <source>Run that distances are measured from</source>
        <translation>Körning som avstånden mäts från</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Körning</translation>
    </message>
    <message>
        <source>Apart (m)</source>
        <translation>Avstånd (m)</translation>
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
        <translation>Lutningar</translation>
    </message>
    <message>
        <source>The same as a share of the energy at the start</source>
        <translation>Detsamma som andel av energin vid starten</translation>
    </message>
    <message>
        <source>Slope evaluations so far</source>
        <translation>Antal lutningsberäkningar hittills</translation>
    </message>
    <message>
        <source>Runs in figures</source>
        <translation>Körningarna i siffror</translation>
    </message>
    <message>
        <source>Distance from %1</source>
        <translation>Avstånd från %1</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, now: max |p − p&apos;|, in m</source>
        <translation>Största avstånd mellan samma vikt i båda körningarna, nu: max |p − p&apos;|, i m</translation>
    </message>
    <message>
        <source>Energy the method got wrong so far, in J: kinetic + potential + losses − energy at the start</source>
        <translation>Energi som metoden hittills fått fel, i J: rörelse + läge + förluster − energin vid start</translation>
    </message>
    <message>
        <source>Method and step of the run</source>
        <translation>Körningens metod och steg</translation>
    </message>
    <message>
        <source>How far the runs are apart, and what each got wrong, at the moment shown</source>
        <translation>Hur långt körningarna är ifrån varandra, och vad var och en fått fel, vid den tidpunkt som visas</translation>
    </message>
</context>
<context>
    <name>ui::CutQuestions</name>
    <message>
        <source>Cut between</source>
        <translation>Klipp mellan</translation>
    </message>
    <message>
        <source>and</source>
        <translation>och</translation>
    </message>
    <message>
        <source>Weight that is to hit the target</source>
        <translation>Vikt som ska träffa målet</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Vilken vikt, räknat från vänster</translation>
    </message>
    <message>
        <source>Method that finds the moments</source>
        <translation>Metod som söker tidpunkterna</translation>
    </message>
    <message>
        <source>Center of the target</source>
        <translation>Målets mitt</translation>
    </message>
    <message>
        <source>Where the middle of the target lies, x in m from the left wall</source>
        <translation>Var målets mitt ligger, x i m från vänstra väggen</translation>
    </message>
    <message>
        <source>Width of the target</source>
        <translation>Målets bredd</translation>
    </message>
    <message>
        <source>How wide the target is, in m</source>
        <translation>Hur brett målet är, i m</translation>
    </message>
    <message>
        <source>First cut time</source>
        <translation>Första klipptid</translation>
    </message>
    <message>
        <source>The earliest moment to cut, in s</source>
        <translation>Den tidigaste tidpunkten att klippa, i s</translation>
    </message>
    <message>
        <source>Last cut time</source>
        <translation>Sista klipptid</translation>
    </message>
    <message>
        <source>The latest moment to cut, in s</source>
        <translation>Den senaste tidpunkten att klippa, i s</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Vikt</translation>
    </message>
    <message>
        <source>by</source>
        <translation>med</translation>
    </message>
    <message>
        <source>Target at</source>
        <translation>Mål vid</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>must be later than the first</source>
        <translation>måste vara senare än den första</translation>
    </message>
</context>
<context>
    <name>ui::CutResults</name>
    <message>
        <source>when-to-cut</source>
        <translation>klipptider</translation>
    </message>
    <message>
        <source>Copy chart</source>
        <translation>Kopiera diagram</translation>
    </message>
    <message>
        <source>Copy chart data</source>
        <translation>Kopiera diagramdata</translation>
    </message>
    <message>
        <source>Finds where the weight first comes to the floor for every moment of the cut, and the moments that hit the target.</source>
        <translation>Söker var vikten först kommer till golvet för varje klipptid, och de tidpunkter som träffar målet.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweep</name>
    <message>
        <source>straight to the floor</source>
        <translation>rakt till golvet</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Weight %1 never comes to the floor.</source>
        <translation>Vikt %1 kommer aldrig till golvet.</translation>
    </message>
    <message>
        <source>No cut makes weight %1 hit the target. The nearest is %2 m off, cut at %3 s.</source>
        <translation>Inget klipp får vikt %1 att träffa målet. Det närmaste hamnar %2 m bredvid, med klipp vid %3 s.</translation>
    </message>
    <message>
        <source>off a wall</source>
        <translation>efter stöt mot vägg</translation>
    </message>
    <message>
        <source>off a weight</source>
        <translation>efter stöt mot vikt</translation>
    </message>
    <message>
        <source>Weight %1, %2</source>
        <translation>Vikt %1, %2</translation>
    </message>
    <message>
        <source>; the run cannot go on to the end</source>
        <translation>; körningen kan inte gå till slutet</translation>
    </message>
    <message>
        <source>; there are more jumps than can be told apart</source>
        <translation>; det finns fler språng än som kan skiljas åt</translation>
    </message>
    <message>
        <source>Of the cut times from %1 s to %2 s, %3 % hit the target. Click the chart, or double-click a row, to cut then.</source>
        <translation>Av klipptiderna från %1 s till %2 s träffar %3 % målet. Klicka i diagrammet, eller dubbelklicka på en rad, för att klippa då.</translation>
    </message>
    <message>
        <source>Cut (s)</source>
        <translation>Klipp (s)</translation>
    </message>
    <message>
        <source>Lands at (m)</source>
        <translation>Landar vid (m)</translation>
    </message>
    <message>
        <source>Landing (s)</source>
        <translation>Landning (s)</translation>
    </message>
    <message>
        <source>On the way</source>
        <translation>På vägen</translation>
    </message>
    <message>
        <source>On the target</source>
        <translation>I målet</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepChart</name>
    <message>
        <source>Landing place against cut time</source>
        <translation>Landningsplats mot klipptid</translation>
    </message>
    <message>
        <source>cut at %1 s</source>
        <translation>klipp vid %1 s</translation>
    </message>
    <message>
        <source>does not land</source>
        <translation>landar inte</translation>
    </message>
    <message>
        <source>lands at %1 m</source>
        <translation>landar vid %1 m</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>efter %1 s</translation>
    </message>
    <message>
        <source>A click cuts the ropes at that moment; moments that hit are listed in the table beside it.</source>
        <translation>Ett klick klipper repen vid den tidpunkten; tidpunkter som träffar står i tabellen bredvid.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepPlot</name>
    <message>
        <source>target</source>
        <translation>mål</translation>
    </message>
    <message>
        <source>hits it</source>
        <translation>träffar</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Klipp vid</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Lands at</source>
        <translation>Landar vid</translation>
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
        <translation>Sök</translation>
    </message>
    <message>
        <source>When to cut?</source>
        <translation>När ska man klippa?</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>ändring av klippet</translation>
    </message>
    <message>
        <source>All ropes are cut at %1 s now. Play to see where weight %2 lands.</source>
        <translation>Alla rep klipps nu vid %1 s. Spela upp för att se var vikt %2 landar.</translation>
    </message>
</context>
<context>
    <name>ui::DraftKeeper</name>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>mappen %1 kan inte skapas</translation>
    </message>
    <message>
        <source>nothing can be written to %1</source>
        <translation>det går inte att skriva till %1</translation>
    </message>
</context>
<context>
    <name>ui::EnergyChart</name>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energi</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>drift %1 J</source>
        <translation>drift %1 J</translation>
    </message>
    <message>
        <source>drift %1 J (%2 %)</source>
        <translation>drift %1 J (%2 %)</translation>
    </message>
    <message>
        <source>drift %1 J (%1 %)</source>
        <translation>drift %1 J (%1 %)</translation>
    </message>
    <message>
        <source>%1 reaches %2 J</source>
        <translation>%1 når %2 J</translation>
    </message>
    <message>
        <source>Scale ends at %1 %2: %3.</source>
        <translation>Skalan slutar vid %1 %2: %3.</translation>
    </message>
    <message>
        <source> − %1 %2</source>
        <translation> − %1 %2</translation>
    </message>
    <message>
        <source>Numerical drift</source>
        <translation>Numerisk drift</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Vid starten</translation>
    </message>
    <message>
        <source>Kinetic</source>
        <translation>Rörelseenergi</translation>
    </message>
    <message>
        <source>Potential</source>
        <translation>Lägesenergi</translation>
    </message>
    <message>
        <source>Lost to air</source>
        <translation>Förlust: luft</translation>
    </message>
    <message>
        <source>Lost to impacts</source>
        <translation>Förlust: stötar</translation>
    </message>
    <message>
        <source>Lost to ropes</source>
        <translation>Förlust: rep</translation>
    </message>
    <message>
        <source>Lost to friction</source>
        <translation>Förlust: friktion</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totalt</translation>
    </message>
</context>
<context>
    <name>ui::EventNavigator</name>
    <message>
        <source>%1: none between %2 s and %3 s.</source>
        <translation>%1: inget mellan %2 s och %3 s.</translation>
    </message>
</context>
<context>
    <name>ui::EventTable</name>
    <message>
        <source>Time (s)</source>
        <translation>Tid (s)</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Händelse</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Vikt</translation>
    </message>
    <message>
        <source>Before (m/s)</source>
        <translation>Före (m/s)</translation>
    </message>
    <message>
        <source>After (m/s)</source>
        <translation>Efter (m/s)</translation>
    </message>
    <message>
        <source>Energy lost (J)</source>
        <translation>Förlust (J)</translation>
    </message>
    <message>
        <source>When it happened, t in s</source>
        <translation>När det hände, t i s</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Vad som hände</translation>
    </message>
    <message>
        <source>The weights it happened to, counted from the left</source>
        <translation>Vikterna det hände, räknat från vänster</translation>
    </message>
    <message>
        <source>Speed |v| right before, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Farten |v| strax före, i m/s. Viktens; där två möts den förstnämndas</translation>
    </message>
    <message>
        <source>Speed |v| right after, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Farten |v| strax efter, i m/s. Viktens; där två möts den förstnämndas</translation>
    </message>
    <message>
        <source>Kinetic energy turned into heat by the event, in J. Between two weights ½ (1 − e²) μ v², with the speed v towards each other and 1/μ = 1/m₁ + 1/m₂</source>
        <translation>Rörelseenergi som händelsen gör till värme, i J. Mellan två vikter ½ (1 − e²) μ v², med farten v mot varandra och 1/μ = 1/m₁ + 1/m₂</translation>
    </message>
</context>
<context>
    <name>ui::EventWords</name>
    <message>
        <source>All events</source>
        <translation>Alla händelser</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Stötar</translation>
    </message>
    <message>
        <source>Turning points</source>
        <translation>Vändlägen</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Klipp</translation>
    </message>
    <message>
        <source>Ropes slack and taut</source>
        <translation>Slaka och spända rep</translation>
    </message>
    <message>
        <source>Coming to rest</source>
        <translation>Kommer i vila</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Klipp</translation>
    </message>
    <message>
        <source>Turning point</source>
        <translation>Vändläge</translation>
    </message>
    <message>
        <source>Rope slack</source>
        <translation>Repet slaknar</translation>
    </message>
    <message>
        <source>Rope taut</source>
        <translation>Repet spänns</translation>
    </message>
    <message>
        <source>Impact on the floor</source>
        <translation>Stöt mot golvet</translation>
    </message>
    <message>
        <source>Impact on the ceiling</source>
        <translation>Stöt mot taket</translation>
    </message>
    <message>
        <source>Impact on the left wall</source>
        <translation>Stöt mot vänstra väggen</translation>
    </message>
    <message>
        <source>Impact on the right wall</source>
        <translation>Stöt mot högra väggen</translation>
    </message>
    <message>
        <source>Impact of weights</source>
        <translation>Stöt mellan vikter</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>Kommer i vila</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alla</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 och %2</translation>
    </message>
</context>
<context>
    <name>ui::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation>Händelser</translation>
    </message>
    <message>
        <source>Kinds of events</source>
        <translation>Sorters händelser</translation>
    </message>
    <message>
        <source>Weight whose events are listed</source>
        <translation>Vikt vars händelser listas</translation>
    </message>
    <message>
        <source>Weight whose events are listed, counted from the left</source>
        <translation>Vikt vars händelser listas, räknat från vänster</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Alla vikter</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Vikt </translation>
    </message>
    <message>
        <source>Run whose events are listed</source>
        <translation>Körning vars händelser listas</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Kopiera som CSV</translation>
    </message>
    <message>
        <source>Copy the chosen events as CSV, or all that are listed (Ctrl+C)</source>
        <translation>Kopiera de valda händelserna som CSV, eller alla som listas (Ctrl+C)</translation>
    </message>
    <message>
        <source>Events copied as CSV: %1</source>
        <translation>Händelser kopierade som CSV: %1</translation>
    </message>
    <message>
        <source>What happened in the run; choosing an event shows its moment</source>
        <translation>Vad som hände i körningen; att välja en händelse visar dess tidpunkt</translation>
    </message>
    <message>
        <source>Kinds of events that are listed</source>
        <translation>Slag av händelser som listas</translation>
    </message>
</context>
<context>
    <name>ui::ExportButton</name>
    <message>
        <source>Export</source>
        <translation>Exportera</translation>
    </message>
    <message>
        <source>Save the chart as a picture or its figures as a table</source>
        <translation>Spara diagrammet som bild eller dess siffror som tabell</translation>
    </message>
    <message>
        <source>Chart…</source>
        <translation>Diagram…</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Exportera diagram</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabell…</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Exportera tabell</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabell (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::Exports</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-bild (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-teckning (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Exportera diagram</translation>
    </message>
    <message>
        <source>Export picture of the scene</source>
        <translation>Exportera bild av scenen</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>scen</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energi</translation>
    </message>
    <message>
        <source>Export energy ledger</source>
        <translation>Exportera energibalans</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabell (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Sparade %1</translation>
    </message>
    <message>
        <source>Not exported</source>
        <translation>Inte exporterat</translation>
    </message>
    <message>
        <source>%1 was not written:
%2</source>
        <translation>%1 skrevs inte:
%2</translation>
    </message>
</context>
<context>
    <name>ui::FileDialog</name>
    <message>
        <source>scene</source>
        <translation>scen</translation>
    </message>
</context>
<context>
    <name>ui::FirstScene</name>
    <message>
        <source>The scene of last time, %1, was not opened: %2</source>
        <translation>Den senaste scenen, %1, öppnades inte: %2</translation>
    </message>
</context>
<context>
    <name>ui::Form</name>
    <message>
        <source>change of %1</source>
        <translation>ändring av %1</translation>
    </message>
</context>
<context>
    <name>ui::HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Tangenter</translation>
    </message>
    <message>
        <source>About Angry Cuts</source>
        <translation>Om Angry Cuts</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Weights hang on ropes and swing; the ropes are cut; the weights fly, bounce and come to rest. Two numerical methods compute the same scene side by side, and an energy ledger shows what each of them gets wrong.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Vikter hänger i rep och svänger; repen klipps; vikterna flyger, studsar och kommer i vila. Två numeriska metoder beräknar samma scen sida vid sida, och en energibalans visar vad var och en av dem räknar fel.&lt;/p&gt;&lt;p&gt;Fri programvara under GNU General Public License, version 3 eller senare.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hjälp</translation>
    </message>
    <message>
        <source>Quick guide</source>
        <translation>Snabbguide</translation>
    </message>
    <message>
        <source>The model</source>
        <translation>Modellen</translation>
    </message>
    <message>
        <source>Teacher&apos;s sheets</source>
        <translation>Lärarblad</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Innehåll</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>S&amp;kriv ut…</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Spara som PDF…</translation>
    </message>
    <message>
        <source>Printed %1</source>
        <translation>%1 utskrivet</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Spara som PDF</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Sparade %1</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Inte sparat</translation>
    </message>
    <message>
        <source>Guide, model or teacher&apos;s sheets</source>
        <translation>Guide, modell eller lärarblad</translation>
    </message>
    <message>
        <source>What this chapter has; the one chosen is shown</source>
        <translation>Vad kapitlet innehåller; det valda visas</translation>
    </message>
    <message>
        <source>The page that is open</source>
        <translation>Sidan som är öppen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Stäng det här fönstret</translation>
    </message>
    <message>
        <source>Print these pages, black on white</source>
        <translation>Skriv ut de här sidorna, svart på vitt</translation>
    </message>
    <message>
        <source>Save these pages as a file</source>
        <translation>Spara de här sidorna som en fil</translation>
    </message>
</context>
<context>
    <name>ui::HitTable</name>
    <message>
        <source>wall</source>
        <translation>vägg</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>vikt</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Klipp vid</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Varar</translation>
    </message>
    <message>
        <source>Lands</source>
        <translation>Landar</translation>
    </message>
    <message>
        <source>Off a</source>
        <translation>Stöt mot</translation>
    </message>
    <message>
        <source>The moment that comes nearest to the target&apos;s center</source>
        <translation>Den tidpunkt som kommer närmast målets mitt</translation>
    </message>
    <message>
        <source>How long the stretch of cut times is that hit</source>
        <translation>Hur långt det intervall av klipptider är som träffar</translation>
    </message>
    <message>
        <source>When the weight lands</source>
        <translation>När vikten landar</translation>
    </message>
    <message>
        <source>What it hits first, before the floor</source>
        <translation>Vad den träffar först, före golvet</translation>
    </message>
    <message>
        <source>Moments that hit</source>
        <translation>Tidpunkter som träffar</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to cut then</source>
        <translation>Dubbelklicka på en rad, eller tryck på Retur, för att klippa då</translation>
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
        <translation>rad %1, kolumn %2: %3</translation>
    </message>
    <message>
        <source>the text ends where a value must stand</source>
        <translation>texten slutar där ett värde måste stå</translation>
    </message>
    <message>
        <source>a value must stand here</source>
        <translation>här måste ett värde stå</translation>
    </message>
    <message>
        <source>a digit must stand here</source>
        <translation>här måste en siffra stå</translation>
    </message>
    <message>
        <source>the text ends inside a string</source>
        <translation>texten slutar inuti en sträng</translation>
    </message>
    <message>
        <source>a control character must be written as an escape</source>
        <translation>ett styrtecken måste skrivas som escapesekvens</translation>
    </message>
    <message>
        <source>unknown escape in a string</source>
        <translation>okänd escapesekvens i en sträng</translation>
    </message>
    <message>
        <source>half a surrogate pair in a string</source>
        <translation>ett halvt surrogatpar i en sträng</translation>
    </message>
    <message>
        <source>four hexadecimal digits must stand here</source>
        <translation>här måste fyra hexadecimala siffror stå</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>för djupt nästlat</translation>
    </message>
    <message>
        <source>a comma or %1 must stand here</source>
        <translation>här måste ett komma eller %1 stå</translation>
    </message>
    <message>
        <source>a key in quotes must stand here</source>
        <translation>här måste en nyckel inom citattecken stå</translation>
    </message>
    <message>
        <source>a colon must stand here</source>
        <translation>här måste ett kolon stå</translation>
    </message>
    <message>
        <source>nothing more may stand here</source>
        <translation>här får inget mer stå</translation>
    </message>
</context>
<context>
    <name>ui::KeysPage</name>
    <message>
        <source>%1, previous</source>
        <translation>%1, föregående</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>I scenen</translation>
    </message>
    <message>
        <source>Wheel, drag</source>
        <translation>Hjul, dra</translation>
    </message>
    <message>
        <source>Zoom, move the view</source>
        <translation>Zooma, flytta vyn</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Dubbelklick</translation>
    </message>
    <message>
        <source>Fit the room</source>
        <translation>Visa hela rummet</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Select a weight</source>
        <translation>Välj en vikt</translation>
    </message>
    <message>
        <source>Drag a weight</source>
        <translation>Dra en vikt</translation>
    </message>
    <message>
        <source>Set its angle or place</source>
        <translation>Ställ in vinkel eller plats</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Skift+dra</translation>
    </message>
    <message>
        <source>Set its rope&apos;s length</source>
        <translation>Ställ in repets längd</translation>
    </message>
    <message>
        <source>Drag its arrow</source>
        <translation>Dra viktens pil</translation>
    </message>
    <message>
        <source>Set its velocity</source>
        <translation>Ställ in hastigheten</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+dra</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Jämna värden</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+pilar</translation>
    </message>
    <message>
        <source>Move the weight</source>
        <translation>Flytta vikten</translation>
    </message>
    <message>
        <source>Alt+Shift+arrows</source>
        <translation>Alt+Skift+pilar</translation>
    </message>
    <message>
        <source>Change its velocity</source>
        <translation>Ändra hastigheten</translation>
    </message>
    <message>
        <source>In the table</source>
        <translation>I tabellen</translation>
    </message>
    <message>
        <source>Ins, Del</source>
        <translation>Insert, Delete</translation>
    </message>
    <message>
        <source>Add, remove weights</source>
        <translation>Lägg till, ta bort vikter</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+V</translation>
    </message>
    <message>
        <source>Copy, paste cells</source>
        <translation>Kopiera, klistra in celler</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Fyll nedåt</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>I ett diagram</translation>
    </message>
    <message>
        <source>Wheel, + −</source>
        <translation>Hjul, + −</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zooma</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Dra</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Zooma till en ruta</translation>
    </message>
    <message>
        <source>Shift+drag, Alt+arrows</source>
        <translation>Skift+dra, Alt+pilar</translation>
    </message>
    <message>
        <source>Move what it shows</source>
        <translation>Flytta det som visas</translation>
    </message>
    <message>
        <source>Double click, 0</source>
        <translation>Dubbelklick, 0</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Visa allt</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Överallt</translation>
    </message>
    <message>
        <source>Return, Escape</source>
        <translation>Retur, Esc</translation>
    </message>
    <message>
        <source>Apply, restore a field</source>
        <translation>Använd, återställ ett fält</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tabb, Skift+Tabb</translation>
    </message>
    <message>
        <source>Next, previous field</source>
        <translation>Nästa, föregående fält</translation>
    </message>
    <message>
        <source>Alt+letter</source>
        <translation>Alt+bokstav</translation>
    </message>
    <message>
        <source>Open that menu</source>
        <translation>Öppna menyn</translation>
    </message>
</context>
<context>
    <name>ui::LessonChooser</name>
    <message>
        <source>Lessons</source>
        <translation>Lektioner</translation>
    </message>
    <message>
        <source>Arrow keys and Enter, or a click, open a lesson.</source>
        <translation>Piltangenterna och Retur, eller ett klick, öppnar en lektion.</translation>
    </message>
</context>
<context>
    <name>ui::LessonPanel</name>
    <message>
        <source>To try</source>
        <translation>Att prova</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alla lektioner</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Dölj</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blad</translation>
    </message>
</context>
<context>
    <name>ui::Lessons</name>
    <message>
        <source>One pendulum</source>
        <translation>En pendel</translation>
    </message>
    <message>
        <source>Watch one weight swing, lose its rope on the way up, fly and bounce: Euler swings higher than it started, RK4 does not.</source>
        <translation>Se hur en vikt svänger, mister sitt rep på väg upp, flyger och studsar: med Euler svänger den högre än den startade, med RK4 inte.</translation>
    </message>
    <message>
        <source>Press R, then cut the rope yourself with C: when must you cut for the longest throw?</source>
        <translation>Tryck på R och klipp sedan repet själv med C: när måste du klippa för det längsta kastet?</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller under Runs: about a tenth of its error is left.</source>
        <translation>Ge Euler ett tio gånger mindre steg under Körningar: ungefär en tiondel av felet blir kvar.</translation>
    </message>
    <message>
        <source>Set the air density to 0: does the total still stay flat with both methods?</source>
        <translation>Sätt luftdensiteten till 0: är den totala energin fortfarande konstant med båda metoderna?</translation>
    </message>
    <message>
        <source>Two weights</source>
        <translation>Två vikter</translation>
    </message>
    <message>
        <source>Watch a small and a large weight of the same lead swing towards each other: when they meet in the air, the light one is thrown back.</source>
        <translation>Se hur en liten och en stor vikt av samma bly svänger mot varandra: när de möts i luften kastas den lätta tillbaka.</translation>
    </message>
    <message>
        <source>Press I to go to the impact and read the speeds before and after under Events.</source>
        <translation>Tryck på I för att gå till stöten och läs av farten före och efter under Händelser.</translation>
    </message>
    <message>
        <source>Give both weights the same mass: who is thrown back now?</source>
        <translation>Ge båda vikterna samma massa: vem kastas tillbaka nu?</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0: how much energy is lost to the impact?</source>
        <translation>Sätt studstalet för vikter till 0: hur mycket energi går förlorad i stöten?</translation>
    </message>
    <message>
        <source>Three pendulums</source>
        <translation>Tre pendlar</translation>
    </message>
    <message>
        <source>Watch three ropes of different length start together and fall out of step: the longer the rope, the slower the swing.</source>
        <translation>Se hur tre olika långa rep startar samtidigt och kommer i otakt: ju längre rep, desto långsammare svängning.</translation>
    </message>
    <message>
        <source>Make the first rope 0.3 m long: the third, four times as long, swings half as fast.</source>
        <translation>Gör det första repet 0,3 m långt: det tredje, som är fyra gånger så långt, svänger hälften så fort.</translation>
    </message>
    <message>
        <source>Change the mass of one weight: is its swing slower now?</source>
        <translation>Ändra en vikts massa: svänger den långsammare nu?</translation>
    </message>
    <message>
        <source>Press U to go from one turning point to the next and read the times under Events.</source>
        <translation>Tryck på U för att gå från ett vändläge till nästa och läs av tiderna under Händelser.</translation>
    </message>
    <message>
        <source>Seven weights in a room</source>
        <translation>Sju vikter i ett rum</translation>
    </message>
    <message>
        <source>Watch seven weights swing, all ropes cut at once: they fly, bounce off each other, the walls and the floor, and two methods soon disagree about where.</source>
        <translation>Se hur sju vikter svänger och alla rep klipps samtidigt: de flyger, studsar mot varandra, väggarna och golvet, och snart är två metoder oense om var de är.</translation>
    </message>
    <message>
        <source>Press V to give each method a view of its own.</source>
        <translation>Tryck på V för att ge varje metod en egen vy.</translation>
    </message>
    <message>
        <source>Guess which weight comes to rest first, and look it up under Events.</source>
        <translation>Gissa vilken vikt som kommer i vila först, och slå upp det under Händelser.</translation>
    </message>
    <message>
        <source>Halve the step of one method: how much later do the two part?</source>
        <translation>Halvera steget för en av metoderna: hur mycket senare skiljs de två åt?</translation>
    </message>
    <message>
        <source>Euler gains energy</source>
        <translation>Euler får energi</translation>
    </message>
    <message>
        <source>Watch Euler swing a pendulum higher and higher without a push, until it goes over the top: its energy comes from the method, not from physics.</source>
        <translation>Se hur Euler låter en pendel svänga allt högre utan att någon knuffar den, tills den slår runt: energin kommer från metoden, inte från fysiken.</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller: it still gains energy, only more slowly.</source>
        <translation>Ge Euler ett tio gånger mindre steg: den får fortfarande energi, bara långsammare.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: all that is hatched was made by the method.</source>
        <translation>Öppna diagrammet Balans: allt som är skrafferat har metoden skapat.</translation>
    </message>
    <message>
        <source>Choose Euler (semi-implicit) for the second run and compare.</source>
        <translation>Välj Euler (semi-implicit) för den andra körningen och jämför.</translation>
    </message>
    <message>
        <source>Two kinds of Euler</source>
        <translation>Två sorters Euler</translation>
    </message>
    <message>
        <source>Watch two methods that differ in a single line, whether the new or the old speed moves the weight: one gains energy for ever, the other never strays far.</source>
        <translation>Se två metoder som skiljer sig på en enda rad, om den nya eller den gamla hastigheten flyttar vikten: den ena får energi för alltid, den andra avviker aldrig långt.</translation>
    </message>
    <message>
        <source>Open the Phase chart: one draws a closed loop, the other a spiral.</source>
        <translation>Öppna diagrammet Fas: den ena ritar en sluten kurva, den andra en spiral.</translation>
    </message>
    <message>
        <source>Switch on Runge–Kutta 4 as a third run with the same step: what does its energy do?</source>
        <translation>Slå på Runge–Kutta 4 som tredje körning med samma steg: vad gör dess energi?</translation>
    </message>
    <message>
        <source>Let it play for a minute at speed 8×: is the first run still the same?</source>
        <translation>Låt det gå en minut i tempo 8×: är den första körningen fortfarande likadan?</translation>
    </message>
    <message>
        <source>Half the step</source>
        <translation>Halva steget</translation>
    </message>
    <message>
        <source>Watch the distance from the first run, which is exact: with half the step Euler errs half as much, and RK4 hardly at all.</source>
        <translation>Se på avståndet från den första körningen, som är exakt: med halva steget gör Euler hälften så stort fel, och RK4 nästan inget alls.</translation>
    </message>
    <message>
        <source>Open Comparison and read the distances after one second and after four.</source>
        <translation>Öppna Jämförelse och läs av avstånden efter en sekund och efter fyra.</translation>
    </message>
    <message>
        <source>Halve the step of Runge–Kutta 4: its error shrinks to about a sixteenth.</source>
        <translation>Halvera steget för Runge–Kutta 4: felet krymper till ungefär en sextondel.</translation>
    </message>
    <message>
        <source>Open Run ▸ Speed and accuracy to see the same for many steps at once.</source>
        <translation>Öppna Körning ▸ Snabbhet och noggrannhet för att se samma sak för många steg på en gång.</translation>
    </message>
    <message>
        <source>Step too large</source>
        <translation>För stort steg</translation>
    </message>
    <message>
        <source>Watch the air stop a balloon in three ways: slowly with a small step, dead with a larger one, and never with one that throws it back faster each time.</source>
        <translation>Se hur luften stoppar en ballong på tre sätt: långsamt med ett litet steg, tvärt med ett större, och aldrig med ett som kastar den tillbaka allt fortare varje gång.</translation>
    </message>
    <message>
        <source>Press R and then → again and again: see how each large step overshoots.</source>
        <translation>Tryck på R och sedan → gång på gång: se hur varje stort steg går för långt.</translation>
    </message>
    <message>
        <source>Open Inside a step for the third run: its one slope points far beyond the other side.</source>
        <translation>Öppna Inuti ett steg för den tredje körningen: dess enda lutning pekar långt förbi andra sidan.</translation>
    </message>
    <message>
        <source>Look for the largest step of the third run that does not blow up.</source>
        <translation>Sök det största steg med vilket den tredje körningen inte divergerar.</translation>
    </message>
    <message>
        <source>Small and large swings</source>
        <translation>Små och stora svängningar</translation>
    </message>
    <message>
        <source>Watch four pendulums of the same length start together: only small swings keep the same time, and the wider one swings, the longer it takes.</source>
        <translation>Se hur fyra lika långa pendlar startar samtidigt: bara små svängningar håller samma takt, och ju vidare en pendel svänger, desto längre tid tar det.</translation>
    </message>
    <message>
        <source>Press U to find the first turning points and compare the times.</source>
        <translation>Tryck på U för att hitta de första vändlägena och jämför tiderna.</translation>
    </message>
    <message>
        <source>Set the start angles to 5°, 10°, 15° and 20°: now they keep step for a long time.</source>
        <translation>Sätt startvinklarna till 5°, 10°, 15° och 20°: nu håller de länge samma takt.</translation>
    </message>
    <message>
        <source>Set one start angle to 179.9°: how long does it stay near the top?</source>
        <translation>Sätt en startvinkel till 179,9°: hur länge stannar den nära toppen?</translation>
    </message>
    <message>
        <source>Slack rope</source>
        <translation>Rep som slaknar</translation>
    </message>
    <message>
        <source>Watch a rod and a rope with the same push: the rod carries its weight over the top, the rope goes slack on the way up and jerks tight on the way down.</source>
        <translation>Se en stång och ett rep med samma knuff: stången för sin vikt över toppen, repet slaknar på väg upp och rycker till på väg ner.</translation>
    </message>
    <message>
        <source>Switch to speed 1/8× at the moment the rope goes slack: the weight flies as if thrown.</source>
        <translation>Växla till tempo 1/8× i det ögonblick repet slaknar: vikten flyger som ett kast.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: how much energy does the jerk cost?</source>
        <translation>Öppna diagrammet Balans: hur mycket energi kostar rycket?</translation>
    </message>
    <message>
        <source>Change gravity until the rope stays taut all the way round.</source>
        <translation>Ändra tyngdaccelerationen tills repet är spänt hela vägen runt.</translation>
    </message>
    <message>
        <source>A throw with and without air</source>
        <translation>Ett kast med och utan luft</translation>
    </message>
    <message>
        <source>Watch two equal throws, one through air and one that the air does not touch: with air the path is shorter, lower and steeper at its end.</source>
        <translation>Se två lika kast, ett genom luft och ett som luften inte påverkar: med luft är banan kortare, lägre och brantare på slutet.</translation>
    </message>
    <message>
        <source>Open the Paths chart: which of the two paths is a parabola?</source>
        <translation>Öppna diagrammet Banor: vilken av de två banorna är en parabel?</translation>
    </message>
    <message>
        <source>Make the first ball ten times as heavy: how much further does it get?</source>
        <translation>Gör den första bollen tio gånger så tung: hur mycket längre kommer den?</translation>
    </message>
    <message>
        <source>Set the air density to 0: now both paths have the same shape.</source>
        <translation>Sätt luftdensiteten till 0: nu har båda banorna samma form.</translation>
    </message>
    <message>
        <source>Terminal velocity</source>
        <translation>Gränshastighet</translation>
    </message>
    <message>
        <source>Watch three balls of one size fall: the light ones soon fall at a constant speed, where the drag of the air is as large as their weight.</source>
        <translation>Se tre lika stora bollar falla: de lätta faller snart med konstant fart, där luftmotståndet är lika stort som tyngdkraften.</translation>
    </message>
    <message>
        <source>Open the Speed chart: whose curve becomes level, and how soon?</source>
        <translation>Öppna diagrammet Fart: vems kurva planar ut, och hur snart?</translation>
    </message>
    <message>
        <source>Read off both level speeds: the second ball is four times as heavy as the first.</source>
        <translation>Läs av båda gränshastigheterna: den andra bollen är fyra gånger så tung som den första.</translation>
    </message>
    <message>
        <source>Set the air density to 0: all three hit the floor together.</source>
        <translation>Sätt luftdensiteten till 0: alla tre når golvet samtidigt.</translation>
    </message>
    <message>
        <source>Infinitely many bounces</source>
        <translation>Oändligt många studsar</translation>
    </message>
    <message>
        <source>Watch a ball that loses a fifth of its speed at every bounce: it bounces infinitely often, and yet all bounces are over within six seconds.</source>
        <translation>Se en boll som förlorar en femtedel av sin fart vid varje studs: den studsar oändligt många gånger, och ändå är alla studsar över inom sex sekunder.</translation>
    </message>
    <message>
        <source>Open the Height chart and zoom in on the end: it looks the same again and again.</source>
        <translation>Öppna diagrammet Höjd och zooma in slutet: det ser likadant ut om och om igen.</translation>
    </message>
    <message>
        <source>Go to the last impacts with I: the times between them form a geometric series.</source>
        <translation>Gå till de sista stötarna med I: tiderna mellan dem bildar en geometrisk serie.</translation>
    </message>
    <message>
        <source>Set the restitution of walls to 0.9: the bounces now last about twice as long.</source>
        <translation>Sätt studstalet för väggar till 0,9: nu varar studsarna ungefär dubbelt så länge.</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>Newtons vagga</translation>
    </message>
    <message>
        <source>Watch one weight knock against four that hang at rest: only the last one flies off, because energy and momentum must both be kept.</source>
        <translation>Se en vikt slå mot fyra som hänger i vila: bara den sista flyger iväg, för både energi och rörelsemängd måste bevaras.</translation>
    </message>
    <message>
        <source>Pull two weights aside: give weight 2 the start angle −40°, too. How many fly off?</source>
        <translation>Dra två vikter åt sidan: ge även vikt 2 startvinkeln −40°. Hur många flyger iväg?</translation>
    </message>
    <message>
        <source>Play the impacts at speed 1/64×: the push passes through four weights in no time.</source>
        <translation>Spela upp stötarna i tempo 1/64×: stöten går genom fyra vikter utan att någon tid går.</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0.5: after a while all swing together.</source>
        <translation>Sätt studstalet för vikter till 0,5: efter en stund svänger alla tillsammans.</translation>
    </message>
    <message>
        <source>Counting π by impacts</source>
        <translation>Räkna π med stötar</translation>
    </message>
    <message>
        <source>Watch a disc a hundred times as heavy drive a light one against the wall: there are 31 impacts before they part, the first digits of π.</source>
        <translation>Se en skiva som är hundra gånger så tung driva en lätt skiva mot väggen: det blir 31 stötar innan de skiljs åt, de första siffrorna i π.</translation>
    </message>
    <message>
        <source>Open Events and choose Impacts: count them until the heavy disc hits the right wall.</source>
        <translation>Öppna Händelser och välj Stötar: räkna dem tills den tunga skivan når den högra väggen.</translation>
    </message>
    <message>
        <source>Make the heavy disc 1000 kg, 10⁴ times the light one: there are 314 impacts.</source>
        <translation>Gör den tunga skivan 1000 kg, 10⁴ gånger den lätta: det blir 314 stötar.</translation>
    </message>
    <message>
        <source>Give the run a step ten times as large: the number stays the same. Why?</source>
        <translation>Ge körningen ett tio gånger så stort steg: antalet är detsamma. Varför?</translation>
    </message>
    <message>
        <source>A thousand pendulums</source>
        <translation>Tusen pendlar</translation>
    </message>
    <message>
        <source>Watch a thousand pendulums start as one straight line, each a hair longer than the next: the line bends, winds up and falls apart into dust.</source>
        <translation>Se tusen pendlar starta som en rak linje, var och en en hårsmån längre än den förra: linjen böjs, rullas ihop och faller sönder till stoft.</translation>
    </message>
    <message>
        <source>Stop after 5 s and after 20 s: are weights that started side by side still neighbours?</source>
        <translation>Stanna efter 5 s och efter 20 s: är vikter som startade bredvid varandra fortfarande grannar?</translation>
    </message>
    <message>
        <source>Set all start angles to 170°: does the line fall apart sooner?</source>
        <translation>Sätt alla startvinklar till 170°: faller linjen sönder tidigare?</translation>
    </message>
    <message>
        <source>Press C while they swing: a thousand weights fly off along a thousand paths.</source>
        <translation>Tryck på C medan de svänger: tusen vikter flyger iväg längs tusen banor.</translation>
    </message>
    <message>
        <source>A pile comes to rest</source>
        <translation>En hög kommer i vila</translation>
    </message>
    <message>
        <source>Watch balls rain into a box and settle: every impact takes some energy, until all lie still and no ball overlaps another.</source>
        <translation>Se bollar regna ner i en låda och lägga sig: varje stöt tar lite energi, tills alla ligger stilla och ingen boll överlappar en annan.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: where has all the energy gone?</source>
        <translation>Öppna diagrammet Balans: vart har all energi tagit vägen?</translation>
    </message>
    <message>
        <source>Set both restitutions to 0.8: how much longer does it take until all lie still?</source>
        <translation>Sätt båda studstalen till 0,8: hur mycket längre tid tar det tills alla ligger stilla?</translation>
    </message>
    <message>
        <source>Make the room twice as wide: how high is the pile now?</source>
        <translation>Gör rummet dubbelt så brett: hur hög är högen nu?</translation>
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
        <translation>&amp;Arkiv</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>S&amp;enast öppnade</translation>
    </message>
    <message>
        <source>&amp;Built-in scenes</source>
        <translation>&amp;Inbyggda scener</translation>
    </message>
    <message>
        <source>Export energy &amp;ledger</source>
        <translation>Exportera ener&amp;gibalans</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigera</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Körning</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Gå till</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Visa</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneler</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mätning</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>V&amp;ikt</translation>
    </message>
    <message>
        <source>&amp;Chart</source>
        <translation>&amp;Diagram</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hjälp</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Panels</source>
        <translation>Paneler</translation>
    </message>
    <message>
        <source>Which of the panels that share this place is shown</source>
        <translation>Vilken av panelerna som delar platsen som visas</translation>
    </message>
</context>
<context>
    <name>ui::MeasurementTable</name>
    <message>
        <source>Method</source>
        <translation>Metod</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Inställning</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fel</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Time/s</source>
        <translation>Tid/s</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Lutningar</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Utfall</translation>
    </message>
    <message>
        <source>Step, or tolerance of an adaptive method</source>
        <translation>Steg, eller tolerans för en adaptiv metod</translation>
    </message>
    <message>
        <source>Largest distance of any weight from where it really is</source>
        <translation>Största avståndet för någon vikt från dess verkliga läge</translation>
    </message>
    <message>
        <source>Largest numerical drift of the energy</source>
        <translation>Största numeriska driften i energin</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Beräkningstid per simulerad sekund</translation>
    </message>
    <message>
        <source>Slope evaluations</source>
        <translation>Lutningsberäkningar</translation>
    </message>
    <message>
        <source>Whether the run came to the end</source>
        <translation>Om körningen kom till slutet</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Mätpunkter</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to open it as a run</source>
        <translation>Dubbelklicka på en rad, eller tryck på Retur, för att öppna den som körning</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>diverged at %1 s</source>
        <translation>divergerade vid %1 s</translation>
    </message>
</context>
<context>
    <name>ui::OpenAsRun</name>
    <message>
        <source>addition of a run</source>
        <translation>tillägg av en körning</translation>
    </message>
</context>
<context>
    <name>ui::PanelTitle</name>
    <message>
        <source>Take the panel out of the window, or put it back</source>
        <translation>Ta ut panelen ur fönstret, eller sätt tillbaka den</translation>
    </message>
    <message>
        <source>Close the panel; the view menu brings it back</source>
        <translation>Stäng panelen; menyn Visa tar fram den igen</translation>
    </message>
</context>
<context>
    <name>ui::PlaybackBar</name>
    <message>
        <source>%1× real time</source>
        <translation>%1× realtid</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed (, and .)</source>
        <translation>Tempo (, och .)</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulerad tid</translation>
    </message>
    <message>
        <source>Whether the computer keeps up with the chosen speed</source>
        <translation>Om datorn hinner med det valda tempot</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>in real time</source>
        <translation>i realtid</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Tempo %1</translation>
    </message>
    <message>
        <source>Simulated seconds in a second of real time</source>
        <translation>Simulerade sekunder på en verklig sekund</translation>
    </message>
    <message>
        <source>Simulated time t, in s: the moment that all views show</source>
        <translation>Simulerad tid t, i s: den tidpunkt som alla vyer visar</translation>
    </message>
</context>
<context>
    <name>ui::PresentationHeader</name>
    <message>
        <source>Simulated time</source>
        <translation>Simulerad tid</translation>
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
        <translation>måste vara minst %1, är %2</translation>
    </message>
    <message>
        <source>must be from %1 to %2, got %3</source>
        <translation>måste vara från %1 till %2, är %3</translation>
    </message>
    <message>
        <source>must be inside the room, got %1</source>
        <translation>måste ligga i rummet, är %1</translation>
    </message>
    <message>
        <source>must put the whole weight, of radius %1 m, inside the room, got %2</source>
        <translation>måste hålla hela vikten, med radien %1 m, i rummet, är %2</translation>
    </message>
    <message>
        <source>must not overlap %1 at the start</source>
        <translation>får inte överlappa %1 vid starten</translation>
    </message>
    <message>
        <source>must be at most %1, got %2</source>
        <translation>får vara högst %1, är %2</translation>
    </message>
</context>
<context>
    <name>ui::ProblemWords</name>
    <message>
        <source>Gravity</source>
        <translation>Tyngdaccelerationen</translation>
    </message>
    <message>
        <source>The air density</source>
        <translation>Luftdensiteten</translation>
    </message>
    <message>
        <source>The room&apos;s width</source>
        <translation>Rummets bredd</translation>
    </message>
    <message>
        <source>The room&apos;s height</source>
        <translation>Rummets höjd</translation>
    </message>
    <message>
        <source>The room&apos;s restitution</source>
        <translation>Väggarnas studstal</translation>
    </message>
    <message>
        <source>The friction</source>
        <translation>Friktionstalet</translation>
    </message>
    <message>
        <source>The weights&apos; restitution</source>
        <translation>Vikternas studstal</translation>
    </message>
    <message>
        <source>The time of the cut</source>
        <translation>Klipptiden</translation>
    </message>
    <message>
        <source>The mass</source>
        <translation>Massan</translation>
    </message>
    <message>
        <source>The radius</source>
        <translation>Radien</translation>
    </message>
    <message>
        <source>The drag coefficient</source>
        <translation>Motståndskoefficienten</translation>
    </message>
    <message>
        <source>The rope&apos;s length</source>
        <translation>Repets längd</translation>
    </message>
    <message>
        <source>The start angle</source>
        <translation>Startvinkeln</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Steget</translation>
    </message>
    <message>
        <source>The rope of weight %1 is tied outside the room.</source>
        <translation>Repet till vikt %1 är fäst utanför rummet.</translation>
    </message>
    <message>
        <source>Weight %1 does not start inside the room.</source>
        <translation>Vikt %1 startar inte i rummet.</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 måste vara %2.</translation>
    </message>
    <message>
        <source>%1 (number %2) must be %3.</source>
        <translation>%1 (nummer %2) måste vara %3.</translation>
    </message>
    <message>
        <source>Weights %1 and %2 overlap at the start.</source>
        <translation>Vikterna %1 och %2 överlappar vid starten.</translation>
    </message>
    <message numerus="yes">
        <source>(and %n more problem(s))</source>
        <translation>
            <numerusform>(och %n problem till)</numerusform>
            <numerusform>(och %n problem till)</numerusform>
        </translation>
    </message>
    <message>
        <source>The angular velocity</source>
        <translation>Vinkelhastigheten</translation>
    </message>
    <message>
        <source>The velocity x</source>
        <translation>Hastigheten x</translation>
    </message>
    <message>
        <source>The velocity y</source>
        <translation>Hastigheten y</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>Toleransen</translation>
    </message>
    <message>
        <source>There are more than %1 runs.</source>
        <translation>Det finns fler än %1 körningar.</translation>
    </message>
    <message>
        <source>There are more than %1 weights.</source>
        <translation>Det finns fler än %1 vikter.</translation>
    </message>
</context>
<context>
    <name>ui::QuantityField</name>
    <message>
        <source>Must be %1</source>
        <translation>Måste vara %1</translation>
    </message>
</context>
<context>
    <name>ui::QuantitySpinBox</name>
    <message>
        <source>several</source>
        <translation>olika</translation>
    </message>
</context>
<context>
    <name>ui::Range</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 eller mer</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>från %1 till %2</translation>
    </message>
</context>
<context>
    <name>ui::RecentFiles</name>
    <message>
        <source>%1 (gone)</source>
        <translation>%1 (borta)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Töm den här listan</translation>
    </message>
    <message>
        <source>The file is no longer there. It is taken off the list.</source>
        <translation>Filen finns inte längre. Den tas bort från listan.</translation>
    </message>
</context>
<context>
    <name>ui::Recovery</name>
    <message>
        <source>The program ended before changes of %1 were saved, on %2.</source>
        <translation>Programmet avslutades den %2, innan ändringar av %1 hade sparats.</translation>
    </message>
    <message>
        <source>a new scene</source>
        <translation>en ny scen</translation>
    </message>
    <message>
        <source>recovery of changes</source>
        <translation>återställning av ändringar</translation>
    </message>
</context>
<context>
    <name>ui::RunWords</name>
    <message>
        <source>Euler (explicit)</source>
        <translation>Euler (explicit)</translation>
    </message>
    <message>
        <source>Euler (semi-implicit)</source>
        <translation>Euler (semi-implicit)</translation>
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
        <translation>Referens</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, tolerans %2</translation>
    </message>
    <message>
        <source>%1, %2 s</source>
        <translation>%1, %2 s</translation>
    </message>
    <message>
        <source>%1, diverged at %2 s. Its last finite state is shown; try a smaller step.</source>
        <translation>%1, divergerade vid %2 s. Det sista ändliga tillståndet visas; prova ett mindre steg.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: one step held more impacts than a step may.</source>
        <translation>%1, stoppade vid %2 s: ett steg hade fler stötar än ett steg får ha.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: the tolerance asks for more or smaller steps than can be taken.</source>
        <translation>%1, stoppade vid %2 s: toleransen kräver fler eller mindre steg än som kan tas.</translation>
    </message>
</context>
<context>
    <name>ui::RunsForm</name>
    <message>
        <source>Method</source>
        <translation>Metod</translation>
    </message>
    <message>
        <source>Step, tolerance</source>
        <translation>Steg, tolerans</translation>
    </message>
    <message>
        <source>Step of run %1</source>
        <translation>Steg för körning %1</translation>
    </message>
    <message>
        <source>Tolerance of run %1</source>
        <translation>Tolerans för körning %1</translation>
    </message>
    <message>
        <source>Method of run %1</source>
        <translation>Metod för körning %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Körning %1</translation>
    </message>
    <message>
        <source>addition of a run</source>
        <translation>tillägg av en körning</translation>
    </message>
    <message>
        <source>removal of a run</source>
        <translation>borttagning av en körning</translation>
    </message>
    <message>
        <source>change of the method</source>
        <translation>ändring av metoden</translation>
    </message>
    <message>
        <source>How the run gets from one moment to the next. The error of a method of order p shrinks with the step h like h to the power of p.</source>
        <translation>Hur körningen kommer från en tidpunkt till nästa. Felet hos en metod av ordning p krymper med steget h som h upphöjt till p.</translation>
    </message>
    <message>
        <source>Step h in s: how much simulated time the method takes at once. Smaller steps are more exact and cost more.</source>
        <translation>Steget h i s: hur mycket simulerad tid metoden tar åt gången. Mindre steg är noggrannare och kostar mer.</translation>
    </message>
    <message>
        <source>Tolerance, without unit: the error the method allows itself in a step, in m, m/s, rad and rad/s. It chooses its steps accordingly.</source>
        <translation>Tolerans, utan enhet: felet metoden tillåter sig i ett steg, i m, m/s, rad och rad/s. Den väljer sina steg därefter.</translation>
    </message>
    <message>
        <source>Compute the scene with this method, too</source>
        <translation>Beräkna scenen också med denna metod</translation>
    </message>
</context>
<context>
    <name>ui::SceneAnnouncer</name>
    <message>
        <source>No weight selected</source>
        <translation>Ingen vikt vald</translation>
    </message>
    <message>
        <source>Weight %1 selected</source>
        <translation>Vikt %1 vald</translation>
    </message>
    <message>
        <source>%1: weight %2, at %3 s</source>
        <comment>an event, such as: Impact on the floor</comment>
        <translation>%1: vikt %2, vid %3 s</translation>
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
        <translation>Vikter kan flyttas vid starten: tryck på Home, eller R för att återställa</translation>
    </message>
</context>
<context>
    <name>ui::SceneDrop</name>
    <message>
        <source>What was dropped</source>
        <translation>Det som släpptes</translation>
    </message>
    <message>
        <source>These are %1 files. Drop one scene file.</source>
        <translation>Detta är %1 filer. Släpp en scenfil.</translation>
    </message>
    <message>
        <source>It is no file on this computer.</source>
        <translation>Det är ingen fil på den här datorn.</translation>
    </message>
    <message>
        <source>It is a folder. Drop a scene file.</source>
        <translation>Det är en mapp. Släpp en scenfil.</translation>
    </message>
</context>
<context>
    <name>ui::SceneFile</name>
    <message>
        <source>not UTF-8</source>
        <translation>inte UTF-8</translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>inte JSON: %1</translation>
    </message>
    <message>
        <source>larger than 64 MiB</source>
        <translation>större än 64 MiB</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>filen är tom</translation>
    </message>
    <message>
        <source>not UTF-8 but UTF-16; save it as UTF-8</source>
        <translation>inte UTF-8 utan UTF-16; spara den som UTF-8</translation>
    </message>
    <message>
        <source>it is no file but a pipe or a device</source>
        <translation>det är ingen fil utan ett rör eller en enhet</translation>
    </message>
</context>
<context>
    <name>ui::SceneFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Osparade ändringar</translation>
    </message>
    <message>
        <source>The scene has changes that are not saved. Save them?</source>
        <translation>Scenen har ändringar som inte är sparade. Vill du spara dem?</translation>
    </message>
    <message>
        <source>What could not be applied is not saved: %1</source>
        <translation>Det som inte kunde tillämpas sparas inte: %1</translation>
    </message>
    <message>
        <source>start of a new scene</source>
        <translation>början på en ny scen</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Öppna scen</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Scener (*.json);;Alla filer (*)</translation>
    </message>
    <message>
        <source>Scene not opened</source>
        <translation>Scenen öppnades inte</translation>
    </message>
    <message>
        <source>%1 was not opened:
%2</source>
        <translation>%1 öppnades inte:
%2</translation>
    </message>
    <message>
        <source>opening of %1</source>
        <translation>öppning av %1</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Spara scen</translation>
    </message>
    <message>
        <source>Scene (*%1 *.json)</source>
        <translation>Scen (*%1 *.json)</translation>
    </message>
    <message>
        <source>Scene not saved</source>
        <translation>Scenen sparades inte</translation>
    </message>
    <message>
        <source>%1 was not saved:
%2</source>
        <translation>%1 sparades inte:
%2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Sparade %1</translation>
    </message>
</context>
<context>
    <name>ui::SceneForm</name>
    <message>
        <source>Cut at</source>
        <translation>Klipp vid</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Vikter</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Tyngdacceleration</translation>
    </message>
    <message>
        <source>Air density</source>
        <translation>Luftdensitet</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Rum</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Bredd</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Stötar</translation>
    </message>
    <message>
        <source>Restitution of walls</source>
        <translation>Studstal för väggar</translation>
    </message>
    <message>
        <source>Friction of walls</source>
        <translation>Friktionstal för väggar</translation>
    </message>
    <message>
        <source>Restitution of weights</source>
        <translation>Studstal för vikter</translation>
    </message>
    <message>
        <source>Unticked: all ropes are cut by hand, with the Cut button</source>
        <translation>Utan bock: alla rep klipps för hand, med knappen Klipp</translation>
    </message>
    <message>
        <source>Time of the cut</source>
        <translation>Klipptid</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>för hand</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>ändring av klippet</translation>
    </message>
    <message>
        <source>How many weights there are, hung up at even intervals. New ones are like the last one.</source>
        <translation>Hur många vikter det finns, upphängda med jämna mellanrum. Nya är som den sista.</translation>
    </message>
    <message>
        <source>Acceleration of free fall g, in m/s². It pulls each weight down with the force m g. On Earth 9.81 m/s².</source>
        <translation>Tyngdacceleration g, i m/s². Den drar varje vikt nedåt med kraften m g. På jorden 9,81 m/s².</translation>
    </message>
    <message>
        <source>Density of the air ρ, in kg/m³. Drag is F = ½ ρ c_d A v² against the velocity, with A = π r². 1.2 kg/m³ at sea level, 0 for vacuum.</source>
        <translation>Luftens densitet ρ, i kg/m³. Luftmotståndet är F = ½ ρ c_d A v² mot hastigheten, med A = π r². 1,2 kg/m³ vid havsytan, 0 för vakuum.</translation>
    </message>
    <message>
        <source>Distance between the walls, in m.</source>
        <translation>Avståndet mellan väggarna, i m.</translation>
    </message>
    <message>
        <source>Distance between floor and ceiling, in m.</source>
        <translation>Avståndet mellan golv och tak, i m.</translation>
    </message>
    <message>
        <source>Share e of the speed towards a wall, the floor or the ceiling with which a weight leaves it: 1 loses nothing, 0 does not bounce.</source>
        <translation>Den andel e av farten mot en vägg, golvet eller taket som en vikt lämnar det med: 1 förlorar inget, 0 studsar inte.</translation>
    </message>
    <message>
        <source>Friction coefficient μ of walls, floor and ceiling. Friction is at most μ times the force, or the impulse, that presses the weight against them.</source>
        <translation>Friktionstal μ för väggar, golv och tak. Friktionen är högst μ gånger den kraft, eller impuls, som trycker vikten mot dem.</translation>
    </message>
    <message>
        <source>Share e of the speed towards each other with which two weights part after an impact: 1 loses nothing, 0 does not bounce.</source>
        <translation>Den andel e av farten mot varandra som två vikter skiljs åt med efter en stöt: 1 förlorar inget, 0 studsar inte.</translation>
    </message>
    <message>
        <source>Simulated time in s at which all ropes are cut.</source>
        <translation>Simulerad tid i s då alla rep klipps.</translation>
    </message>
</context>
<context>
    <name>ui::SceneLoading</name>
    <message>
        <source>Opening %1…</source>
        <translation>Öppnar %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
</context>
<context>
    <name>ui::SceneMarker</name>
    <message>
        <source>Weight %1</source>
        <translation>Vikt %1</translation>
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
        <translation>Scen</translation>
    </message>
    <message>
        <source>a picture&apos;s name must end in .png, .svg or .pdf</source>
        <translation>en bilds namn måste sluta på .png, .svg eller .pdf</translation>
    </message>
</context>
<context>
    <name>ui::SceneReader</name>
    <message>
        <source>is missing</source>
        <translation>saknas</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>måste vara %1, är %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads version %2</source>
        <translation>%1 är nyare än det här programmet, som läser version %2</translation>
    </message>
    <message>
        <source>must have either rope or position, got both</source>
        <translation>måste ha antingen rope eller position, har båda</translation>
    </message>
    <message>
        <source>must have either rope or position, got neither</source>
        <translation>måste ha antingen rope eller position, har ingetdera</translation>
    </message>
    <message>
        <source>velocity goes with position, got it with rope</source>
        <translation>velocity hör till position, men står här med rope</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 tar en tolerans, inget steg</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 tar ett steg, ingen tolerans</translation>
    </message>
    <message>
        <source>must be like &quot;#e69f00&quot;, got %1</source>
        <translation>måste vara som ”#e69f00”, är %1</translation>
    </message>
    <message>
        <source>there is no method named %1</source>
        <translation>det finns ingen metod som heter %1</translation>
    </message>
</context>
<context>
    <name>ui::SceneToolbar</name>
    <message>
        <source>Scene tools</source>
        <translation>Scenverktyg</translation>
    </message>
</context>
<context>
    <name>ui::SceneView</name>
    <message>
        <source>at the selected weight only</source>
        <translation>bara vid den valda vikten</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>hastighet</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>tyngdkraft</translation>
    </message>
    <message>
        <source>air</source>
        <translation>luft</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>rep</translation>
    </message>
    <message>
        <source>weights enlarged</source>
        <translation>vikterna förstorade</translation>
    </message>
    <message>
        <source>Δx %1, Δy %2</source>
        <translation>Δx %1, Δy %2</translation>
    </message>
    <message>
        <source>Trails shortened: many weights</source>
        <translation>Kortare spår: många vikter</translation>
    </message>
    <message>
        <source>No trails: too many weights</source>
        <translation>Inga spår: för många vikter</translation>
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
        <translation>QPainter (OpenGL förlorades)</translation>
    </message>
    <message>
        <source>QPainter (no OpenGL 3.3)</source>
        <translation>QPainter (ingen OpenGL 3.3)</translation>
    </message>
    <message>
        <source>QPainter (software OpenGL would be slower)</source>
        <translation>QPainter (OpenGL i programvara vore långsammare)</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scen</translation>
    </message>
    <message>
        <source>step × %1</source>
        <translation>steg × %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stopwatch runs</source>
        <translation>stoppuret går</translation>
    </message>
    <message>
        <source>stopwatch stands</source>
        <translation>stoppuret står</translation>
    </message>
    <message>
        <source>Hit at %1 s</source>
        <translation>Träff vid %1 s</translation>
    </message>
    <message>
        <source>Missed by %1 m at %2 s</source>
        <translation>Miss med %1 m vid %2 s</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Mål</translation>
    </message>
    <message>
        <source>The room with its weights and ropes. A click selects a weight, the wheel zooms, dragging moves the view.</source>
        <translation>Rummet med dess vikter och rep. Ett klick väljer en vikt, hjulet zoomar, att dra flyttar vyn.</translation>
    </message>
</context>
<context>
    <name>ui::SeparationChart</name>
    <message>
        <source>Distance between the runs over time</source>
        <translation>Avstånd mellan körningarna över tiden</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Avstånd</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, in m, on a logarithmic axis</source>
        <translation>Största avstånd mellan samma vikt i båda körningarna, i m, på en logaritmisk axel</translation>
    </message>
</context>
<context>
    <name>ui::Settings</name>
    <message>
        <source>The settings in %1 were damaged; what could not be read is as at first.</source>
        <translation>Inställningarna i %1 var skadade; det som inte gick att läsa är som från början.</translation>
    </message>
    <message>
        <source>Settings are not remembered: nothing can be written to %1</source>
        <translation>Inställningar sparas inte: inget kan skrivas till %1</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPanel</name>
    <message>
        <source>Map</source>
        <translation>Kartlägg</translation>
    </message>
    <message>
        <source>Stability map</source>
        <translation>Stabilitetskarta</translation>
    </message>
    <message>
        <source>Method of the map</source>
        <translation>Kartans metod</translation>
    </message>
    <message>
        <source>What the map changes besides the step</source>
        <translation>Vad kartan ändrar utöver steget</translation>
    </message>
    <message>
        <source>Simulated time of each run</source>
        <translation>Simulerad tid för varje körning</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportera…</translation>
    </message>
    <message>
        <source>Step ×</source>
        <translation>Steg ×</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Simulerad tid</translation>
    </message>
    <message>
        <source>rope length</source>
        <translation>replängd</translation>
    </message>
    <message>
        <source>air density</source>
        <translation>luftdensitet</translation>
    </message>
    <message>
        <source>Finds the largest step at which each method stays bounded, that is, makes less energy out of nothing than the scene has to move with.</source>
        <translation>Söker det största steg med vilket varje metod förblir begränsad, det vill säga skapar mindre energi ur intet än scenen har att röra sig med.</translation>
    </message>
    <message>
        <source>stability</source>
        <translation>stabilitet</translation>
    </message>
    <message>
        <source>Export stability map</source>
        <translation>Exportera stabilitetskarta</translation>
    </message>
    <message>
        <source>For which steps the run keeps its energy, and for which it grows beyond all bounds</source>
        <translation>För vilka steg körningen behåller sin energi, och för vilka den växer bortom alla gränser</translation>
    </message>
    <message>
        <source>How long each run is followed, in s: what grows slowly needs time to show</source>
        <translation>Hur länge varje körning följs, i s: det som växer långsamt behöver tid för att synas</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>Spara kartan som bild</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPlot</name>
    <message>
        <source>drift under 1 %</source>
        <translation>drift under 1 %</translation>
    </message>
    <message>
        <source>under 10 %</source>
        <translation>under 10 %</translation>
    </message>
    <message>
        <source>up to 100 %</source>
        <translation>upp till 100 %</translation>
    </message>
    <message>
        <source>energy more than doubled</source>
        <translation>energin mer än fördubblad</translation>
    </message>
    <message>
        <source>diverged</source>
        <translation>divergerade</translation>
    </message>
    <message>
        <source>%1, each run over %2 s. Drift as a share of the energy the scene has to move with; empty: the weights do not fit the room.</source>
        <translation>%1, varje körning över %2 s. Drift som andel av energin som scenen har att röra sig med; tomt: vikterna får inte plats i rummet.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Length of the longest rope</source>
        <translation>Längsta repets längd</translation>
    </message>
    <message>
        <source>Air density (kg/m³)</source>
        <translation>Luftdensitet (kg/m³)</translation>
    </message>
</context>
<context>
    <name>ui::StepPanel</name>
    <message>
        <source>of weight</source>
        <translation>för vikt</translation>
    </message>
    <message>
        <source>Weight whose step is shown</source>
        <translation>Vikt vars steg visas</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Vilken vikt, räknat från vänster</translation>
    </message>
    <message>
        <source>Run whose step is shown</source>
        <translation>Körning vars steg visas</translation>
    </message>
    <message>
        <source>Part of the step</source>
        <translation>Del av steget</translation>
    </message>
    <message>
        <source>Events divide a step: the method starts anew after each</source>
        <translation>Händelser delar ett steg: metoden börjar om efter var och en</translation>
    </message>
    <message>
        <source>The coming step takes long to compute: go on to see it.</source>
        <translation>Nästa steg tar lång tid att beräkna: gå vidare för att se det.</translation>
    </message>
    <message>
        <source>Part %1 of %2</source>
        <translation>Del %1 av %2</translation>
    </message>
    <message>
        <source>There is no step to show.</source>
        <translation>Det finns inget steg att visa.</translation>
    </message>
    <message>
        <source>The reference takes no slopes: choose another run.</source>
        <translation>Referensen har inga lutningar: välj en annan körning.</translation>
    </message>
    <message>
        <source>Nothing moves the weight in this step.</source>
        <translation>Ingenting rör vikten i det här steget.</translation>
    </message>
    <message>
        <source>to come, from %1 s to %2 s</source>
        <translation>kommande, från %1 s till %2 s</translation>
    </message>
    <message>
        <source>from %1 s to %2 s</source>
        <translation>från %1 s till %2 s</translation>
    </message>
</context>
<context>
    <name>ui::StepPlot</name>
    <message>
        <source>The step against time</source>
        <translation>Steget mot tiden</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exakt</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>The exact way, the slopes that the method took, and its end</source>
        <translation>Den exakta vägen, lutningarna som metoden tog, och dess slut</translation>
    </message>
</context>
<context>
    <name>ui::StepTable</name>
    <message>
        <source>The step in numbers</source>
        <translation>Steget i siffror</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Mean slope</source>
        <translation>Medellutning</translation>
    </message>
    <message>
        <source>End, %1</source>
        <translation>Slut, %1</translation>
    </message>
    <message>
        <source>End, exact</source>
        <translation>Slut, exakt</translation>
    </message>
    <message>
        <source>By a Taylor series from the same start</source>
        <translation>Med en Taylorserie från samma start</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Andel</translation>
    </message>
    <message>
        <source>%1 in %2
slope in %3</source>
        <translation>%1 i %2
lutning i %3</translation>
    </message>
    <message>
        <source>Error
in m</source>
        <translation>Fel
i m</translation>
    </message>
    <message>
        <source>The slopes that the method took on its way, and where other methods end</source>
        <translation>Lutningarna som metoden tog på vägen, och var andra metoder slutar</translation>
    </message>
    <message>
        <source>Share of the slope in the mean that the step is taken with</source>
        <translation>Lutningens andel i det medelvärde som steget tas med</translation>
    </message>
    <message>
        <source>%1 at the start and the end, and as a slope how fast it changes</source>
        <translation>%1 vid början och slutet, och som lutning hur fort det ändras</translation>
    </message>
    <message>
        <source>Distance of the end from the exact one, in m: the error of this step alone</source>
        <translation>Slutets avstånd från det exakta, i m: felet i bara detta steg</translation>
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
        <translation>true eller false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>ett tal</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>en text</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>en lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ett objekt</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>måste vara %1, är %2</translation>
    </message>
    <message>
        <source>%1 is too large or too small to reckon with</source>
        <translation>%1 är för stort eller för litet att räkna med</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>okänd nyckel %1</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>förekommer två gånger</translation>
    </message>
    <message>
        <source>must have %1 entries, got %2</source>
        <translation>måste ha %1 värden, har %2</translation>
    </message>
    <message>
        <source>must have %1 to %2 entries, got %3</source>
        <translation>måste ha %1 till %2 värden, har %3</translation>
    </message>
</context>
<context>
    <name>ui::TaskRow</name>
    <message>
        <source>Progress</source>
        <translation>Förlopp</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Avbryt</translation>
    </message>
    <message>
        <source>Compute in the background; the same button stops it</source>
        <translation>Beräkna i bakgrunden; samma knapp avbryter</translation>
    </message>
</context>
<context>
    <name>ui::TimeCommands</name>
    <message>
        <source>Go to a time</source>
        <translation>Gå till en tidpunkt</translation>
    </message>
    <message>
        <source>Simulated time in s</source>
        <translation>Simulerad tid i s</translation>
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
        <translation>Tidslinje</translation>
    </message>
    <message>
        <source>events from %1</source>
        <translation>händelser från %1</translation>
    </message>
    <message>
        <source>%1 s: %2, weight: %3</source>
        <translation>%1 s: %2, vikt: %3</translation>
    </message>
    <message>
        <source>The recording from its start to its end, with marks for events. A click or dragging shows another moment; Home, End and the arrow keys do, too.</source>
        <translation>Inspelningen från början till slut, med märken för händelser. Ett klick eller att dra visar en annan tidpunkt; det gör Home, End och piltangenterna också.</translation>
    </message>
</context>
<context>
    <name>ui::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Rundtur</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Scenen</translation>
    </message>
    <message>
        <source>Weights on ropes. Filled ones follow the first method, rings the others. At the start drag a weight to turn its rope; the wheel zooms.</source>
        <translation>Vikter på rep. Fyllda följer den första metoden, ringar de andra. Dra i en vikt vid starten för att vrida dess rep; hjulet zoomar.</translation>
    </message>
    <message>
        <source>Play and cut</source>
        <translation>Spela och klipp</translation>
    </message>
    <message>
        <source>Space plays and stops. C cuts all ropes, R goes back to the start. Slow motion makes an impact last for seconds.</source>
        <translation>Mellanslag spelar och stannar. C klipper alla rep, R går tillbaka till starten. Ultrarapid låter en stöt vara i sekunder.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Steg för steg</translation>
    </message>
    <message>
        <source>The arrow keys → and ← go by one step, I goes to the next impact. Drag on this line to see any moment again.</source>
        <translation>Piltangenterna → och ← går ett steg, I går till nästa stöt. Dra längs linjen för att se vilken tidpunkt som helst igen.</translation>
    </message>
    <message>
        <source>Where the energy goes</source>
        <translation>Vart energin tar vägen</translation>
    </message>
    <message>
        <source>The total should be a flat line. What it climbs or falls was made or lost by the method, not by nature.</source>
        <translation>Summan borde vara en rak linje. Det den stiger eller faller har metoden skapat eller förlorat, inte naturen.</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Metoder sida vid sida</translation>
    </message>
    <message>
        <source>Up to four methods compute the same scene. Choose them and their steps here, and see who is right. Lessons, at the top right, has scenes to begin with.</source>
        <translation>Upp till fyra metoder beräknar samma scen. Välj dem och deras steg här, och se vem som har rätt. Under Lektioner, uppe till höger, finns scener att börja med.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Hoppa över</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Bakåt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 av %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nästa</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Börja</translation>
    </message>
    <message>
        <source>End the tour; the Help menu has it again</source>
        <translation>Avsluta rundturen; den finns kvar i menyn Hjälp</translation>
    </message>
    <message>
        <source>Show the hint before</source>
        <translation>Visa föregående tips</translation>
    </message>
    <message>
        <source>Go on with the tour, or end it</source>
        <translation>Gå vidare i rundturen, eller avsluta den</translation>
    </message>
</context>
<context>
    <name>ui::TradeWindow</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Snabbhet och noggrannhet</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilitet</translation>
    </message>
    <message>
        <source>%1 is run %2 now.</source>
        <translation>%1 är nu körning %2.</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Vad som mäts</translation>
    </message>
    <message>
        <source>What accuracy costs, or how large steps may be</source>
        <translation>Vad noggrannhet kostar, eller hur stora steg får vara</translation>
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
        <translation>%1 kommer inte i närheten med de uppmätta inställningarna</translation>
    </message>
    <message>
        <source>%1 needs no more than %2</source>
        <translation>%1 behöver högst %2</translation>
    </message>
    <message>
        <source>%1 would need %2 (extrapolated along its order)</source>
        <translation>%1 skulle behöva %2 (extrapolerat efter metodens ordning)</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 behöver %2</translation>
    </message>
    <message>
        <source>Measured over %1 s.</source>
        <translation>Mätt över %1 s.</translation>
    </message>
    <message>
        <source>Measured over the first %1 s of %2 s: later not even the reference solution knows to 10⁻⁶ m where the weights are.</source>
        <translation>Mätt över de första %1 s av %2 s: senare vet inte ens referenslösningen på 10⁻⁶ m när var vikterna är.</translation>
    </message>
    <message>
        <source>%1: no order seen</source>
        <translation>%1: ingen ordning att se</translation>
    </message>
    <message>
        <source>%1: order %2</source>
        <translation>%1: ordning %2</translation>
    </message>
    <message>
        <source>a tolerance of %1 and %2 of computing</source>
        <translation>en tolerans på %1 och %2 beräkningstid</translation>
    </message>
    <message>
        <source>a step of %1 and %2 of computing</source>
        <translation>ett steg på %1 och %2 beräkningstid</translation>
    </message>
    <message>
        <source>%1: none that was tried</source>
        <translation>%1: inget som prövades</translation>
    </message>
    <message>
        <source>%1: any</source>
        <translation>%1: vilket som helst</translation>
    </message>
    <message>
        <source>%1: %2 s</source>
        <translation>%1: %2 s</translation>
    </message>
    <message>
        <source>Largest step that stays bounded over %1 s, that is, makes less energy out of nothing than the scene has to move with. %2.</source>
        <translation>Största steg som förblir begränsat över %1 s, det vill säga skapar mindre energi ur intet än scenen har att röra sig med. %2.</translation>
    </message>
    <message>
        <source>No time was simulated.</source>
        <translation>Ingen tid simulerades.</translation>
    </message>
    <message>
        <source>To be right within %1 over %2 s: %3.</source>
        <translation>För ett fel på högst %1 över %2 s: %3.</translation>
    </message>
</context>
<context>
    <name>ui::TravelBar</name>
    <message>
        <source>How far the computing has come</source>
        <translation>Hur långt beräkningen har kommit</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Stoppa (Esc)</translation>
    </message>
    <message>
        <source>Computing: %1 s</source>
        <translation>Beräknar: %1 s</translation>
    </message>
    <message>
        <source>Computing one step for %1 s</source>
        <translation>Beräknar ett steg sedan %1 s</translation>
    </message>
</context>
<context>
    <name>ui::UndoCommands</name>
    <message>
        <source>Undone</source>
        <translation>Ångrat</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Ångrat: %1</translation>
    </message>
    <message>
        <source>Done again</source>
        <translation>Gjort om</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Gjort om: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Ångra</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Ångra %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Gör om</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Gör om %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightChart</name>
    <message>
        <source>Height</source>
        <translation>Höjd</translation>
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
        <translation>Fart</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>The first %1 of %2 weights</source>
        <translation>De första %1 av %2 vikter</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tid</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Weight %1</source>
        <translation>Vikt %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightColumns</name>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radie</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Motståndskoefficient</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Färg</translation>
    </message>
    <message>
        <source>Hangs on</source>
        <translation>Hänger i</translation>
    </message>
    <message>
        <source>Pivot x</source>
        <translation>Fäste x</translation>
    </message>
    <message>
        <source>Pivot y</source>
        <translation>Fäste y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Längd</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Startvinkel</translation>
    </message>
    <message>
        <source>Angular velocity</source>
        <translation>Vinkelhastighet</translation>
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
        <translation>Hastighet x</translation>
    </message>
    <message>
        <source>Velocity y</source>
        <translation>Hastighet y</translation>
    </message>
    <message>
        <source>must be %1, got “%2”</source>
        <translation>tillåtet: %1; angivet: ”%2”</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisk</translation>
    </message>
    <message>
        <source>like #e69f00, or automatic</source>
        <translation>som #e69f00, eller automatisk</translation>
    </message>
    <message>
        <source>%1, %2 or %3</source>
        <translation>%1, %2 eller %3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>inget</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>rep</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>stång</translation>
    </message>
    <message>
        <source>Color of the weight, such as #e69f00, or automatic</source>
        <translation>Viktens färg, till exempel #e69f00, eller automatiskt</translation>
    </message>
    <message>
        <source>What holds the weight at the start: a rope, a rod, or nothing</source>
        <translation>Vad som håller vikten vid starten: ett rep, en stång eller inget</translation>
    </message>
    <message>
        <source>Where the rope is tied: x from the left wall, y from the floor, in m</source>
        <translation>Var repet är fäst: x från vänstra väggen, y från golvet, i m</translation>
    </message>
    <message>
        <source>Angular velocity ω at the start, in °/s, positive counterclockwise</source>
        <translation>Vinkelhastighet ω vid starten, i °/s, positiv moturs</translation>
    </message>
    <message>
        <source>Center of the weight at the start: x from the left wall, y from the floor, in m</source>
        <translation>Viktens mitt vid starten: x från vänstra väggen, y från golvet, i m</translation>
    </message>
    <message>
        <source>Velocity v at the start: x to the right, y up, in m/s</source>
        <translation>Hastighet v vid starten: x åt höger, y uppåt, i m/s</translation>
    </message>
    <message>
        <source>Mass m, in kg. It does not matter for a swing without air; with air a heavier weight is slowed down less.</source>
        <translation>Massan m, i kg. Utan luft spelar den ingen roll för en svängning; med luft bromsas en tyngre vikt mindre.</translation>
    </message>
    <message>
        <source>Radius r, in m. Air meets the area A = π r².</source>
        <translation>Radien r, i m. Luften möter arean A = π r².</translation>
    </message>
    <message>
        <source>Drag coefficient c_d, without unit: how well the shape is held up by air. 0.47 for a sphere.</source>
        <translation>Motståndskoefficient c_d, utan enhet: hur mycket formen hejdas av luft. 0,47 för ett klot.</translation>
    </message>
    <message>
        <source>Length of the rope L, in m: from its pivot to the center of the weight. A small swing takes T = 2π √(L/g).</source>
        <translation>Repets längd L, i m: från upphängningen till viktens mitt. En liten svängning tar T = 2π √(L/g).</translation>
    </message>
    <message>
        <source>Angle θ of the rope at the start, in degrees from straight down, positive to the right.</source>
        <translation>Repets vinkel θ vid starten, i grader från rakt ned, positiv åt höger.</translation>
    </message>
</context>
<context>
    <name>ui::WeightDrag</name>
    <message>
        <source>Angle %1°</source>
        <translation>Vinkel %1°</translation>
    </message>
    <message>
        <source>Length %1 m</source>
        <translation>Längd %1 m</translation>
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
        <translation>ändring av hastigheten</translation>
    </message>
    <message>
        <source>move of a weight</source>
        <translation>flytt av en vikt</translation>
    </message>
    <message>
        <source>overlaps another weight</source>
        <translation>överlappar en annan vikt</translation>
    </message>
    <message>
        <source>outside the room</source>
        <translation>utanför rummet</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>inte möjligt</translation>
    </message>
</context>
<context>
    <name>ui::WeightsClipboard</name>
    <message>
        <source>Weight %1, %2: %3</source>
        <translation>Vikt %1, %2: %3</translation>
    </message>
    <message>
        <source>a weight on a rope has none, got “%1”</source>
        <translation>finns inte för en vikt i ett rep; angivet: ”%1”</translation>
    </message>
    <message>
        <source>a weight that hangs on nothing has none, got “%1”</source>
        <translation>finns inte för en vikt som inte hänger i något; angivet: ”%1”</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>är tom</translation>
    </message>
    <message>
        <source>Line %1 has another number of columns than the first (%2, not %3).</source>
        <translation>Rad %1 har ett annat antal kolumner än den första (%2, inte %3).</translation>
    </message>
    <message>
        <source>There are too many columns: %1, and from %2 on the table has %3.</source>
        <translation>Det är för många kolumner: %1, och från %2 har tabellen %3.</translation>
    </message>
    <message>
        <source>There would be more than %1 weights.</source>
        <translation>Det skulle bli fler än %1 vikter.</translation>
    </message>
    <message>
        <source>The clipboard holds no text.</source>
        <translation>Urklipp innehåller ingen text.</translation>
    </message>
    <message>
        <source>There are only headings.</source>
        <translation>Det finns bara rubriker.</translation>
    </message>
</context>
<context>
    <name>ui::WeightsForm</name>
    <message>
        <source>All</source>
        <translation>Alla</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Vikt</translation>
    </message>
    <message>
        <source>Which weight the fields below belong to, counted from the left</source>
        <translation>Vilken vikt fälten nedan gäller, räknat från vänster</translation>
    </message>
    <message>
        <source>Rope</source>
        <translation>Rep</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Längd</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Startvinkel</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Kropp</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Massa</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radie</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Motståndskoefficient</translation>
    </message>
    <message>
        <source>All weights in a table…</source>
        <translation>Alla vikter i en tabell…</translation>
    </message>
    <message>
        <source>Change many weights at once, and copy them from and to spreadsheets</source>
        <translation>Ändra många vikter på en gång, och kopiera dem från och till kalkylblad</translation>
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
        <translation>Stäng</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Vikttabell</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Lägg till</translation>
    </message>
    <message>
        <source>Add a weight</source>
        <translation>Lägg till en vikt</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicera</translation>
    </message>
    <message>
        <source>Add a copy of each selected weight</source>
        <translation>Lägg till en kopia av varje vald vikt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ta bort</translation>
    </message>
    <message>
        <source>Remove the selected weights</source>
        <translation>Ta bort de valda vikterna</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiera</translation>
    </message>
    <message>
        <source>Copy the selected cells for a spreadsheet</source>
        <translation>Kopiera de valda cellerna för ett kalkylprogram</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Klistra in</translation>
    </message>
    <message>
        <source>Paste cells, from a spreadsheet too, over those from the first selected one on</source>
        <translation>Klistra in celler, även från ett kalkylprogram, från den första valda cellen och framåt</translation>
    </message>
    <message>
        <source>Paste as new</source>
        <translation>Klistra in som nya</translation>
    </message>
    <message>
        <source>Add what was copied as new weights</source>
        <translation>Lägg till det kopierade som nya vikter</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Fyll nedåt</translation>
    </message>
    <message>
        <source>Give all selected rows what the first of them holds</source>
        <translation>Ge alla valda rader det som den första av dem har</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>ändring av %1</translation>
    </message>
    <message>
        <source>Nothing was changed. %1</source>
        <translation>Inget ändrades. %1</translation>
    </message>
    <message>
        <source>addition of a weight</source>
        <translation>tillägg av en vikt</translation>
    </message>
    <message>
        <source>duplication of weights</source>
        <translation>duplicering av vikter</translation>
    </message>
    <message>
        <source>removal of weights</source>
        <translation>borttagning av vikter</translation>
    </message>
    <message>
        <source>Rows copied: %1</source>
        <translation>Kopierade rader: %1</translation>
    </message>
    <message>
        <source>pasting</source>
        <translation>inklistring</translation>
    </message>
    <message>
        <source>Rows pasted: %1</source>
        <translation>Inklistrade rader: %1</translation>
    </message>
    <message>
        <source>Rows pasted: %1; new weights: %2</source>
        <translation>Inklistrade rader: %1; nya vikter: %2</translation>
    </message>
    <message>
        <source>filling down</source>
        <translation>fyllning nedåt</translation>
    </message>
    <message>
        <source>One row for each weight. Return edits a cell, of all selected rows at once.</source>
        <translation>En rad för varje vikt. Retur ändrar en cell, i alla valda rader på en gång.</translation>
    </message>
</context>
<context>
    <name>ui::WindowFace</name>
    <message>
        <source>Bring them back</source>
        <translation>Hämta tillbaka dem</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Förkasta</translation>
    </message>
    <message>
        <source>Undo the change</source>
        <translation>Ångra ändringen</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a crash: %1</source>
        <translation>Ändringar som inte är sparade kan inte säkras mot en krasch: %1</translation>
    </message>
    <message>
        <source>&amp;Colors</source>
        <translation>Fär&amp;ger</translation>
    </message>
    <message>
        <source>Like the &amp;desktop</source>
        <translation>Som &amp;skrivbordet</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Ljust</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Mörkt</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Te&amp;xtstorlek</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Normal</translation>
    </message>
    <message>
        <source>&amp;Large</source>
        <translation>&amp;Stor</translation>
    </message>
    <message>
        <source>&amp;Very large</source>
        <translation>&amp;Mycket stor</translation>
    </message>
    <message>
        <source>&amp;Drawn by</source>
        <translation>&amp;Ritas med</translation>
    </message>
    <message>
        <source>&amp;Automatic choice</source>
        <translation>&amp;Automatiskt val</translation>
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
        <translation>S&amp;pråk</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>Inte tillämpat: %1</translation>
    </message>
    <message>
        <source>%1[*] – Angry Cuts</source>
        <translation>%1[*] – Angry Cuts</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Ny scen</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Ritas med %1</translation>
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
        <translation>Scen</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Vikter</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Körningar</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagram</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Jämförelse</translation>
    </message>
    <message>
        <source>Inside a step</source>
        <translation>Inuti ett steg</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Händelser</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Vikttabell</translation>
    </message>
</context>
<context>
    <name>ui::WorkPrecisionPlot</name>
    <message>
        <source>slope %1</source>
        <translation>lutning %1</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Beräkningstid per simulerad sekund</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Largest position error</source>
        <translation>Största lägesfel</translation>
    </message>
</context>
</TS>
