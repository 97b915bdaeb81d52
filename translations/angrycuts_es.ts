<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Carpeta de archivos</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Acceso directo</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Seleccionar todo</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>&amp;Aumentar</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>&amp;Disminuir</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>Opción desconocida «%1».</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>Opciones desconocidas: %1.</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>Falta el valor después de «%1».</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>Valor inesperado después de «%1».</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Ver en:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Carpeta:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>&amp;Nombre de archivo:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Tipo de archivo:</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Buscar carpeta</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Ir atrás</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Ir adelante</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Carpeta superior</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Ir a la carpeta superior</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Crear carpeta nueva</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Crear una carpeta nueva</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Nueva carpeta</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Nueva carpeta</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Vista de lista</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Cambiar a la vista de lista</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Vista detallada</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Cambiar a la vista detallada</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Barra lateral</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Lista de lugares y marcadores</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Carpetas</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Lugares recientes</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Abrir</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Guardar como</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Elegir</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Cambia&amp;r nombre</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Mostrar </translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>Mostrar arc&amp;hivos ocultos</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 ya existe.
¿Desea reemplazarlo?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>«%1» está protegido contra escritura.
¿Desea borrarlo de todos modos?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>¿Seguro que desea borrar «%1»?</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>No se pudo borrar la carpeta.</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Archivo no encontrado.
Compruebe el nombre del archivo.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Carpeta no encontrada.
Compruebe el nombre de la carpeta.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Última modificación</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mi equipo</translation>
    </message>
</context>
<context>
    <name>QGnomeTheme</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;Aceptar</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>C&amp;errar</translation>
    </message>
    <message>
        <source>Close without Saving</source>
        <translation>Cerrar sin guardar</translation>
    </message>
</context>
<context>
    <name>QIODevice</name>
    <message>
        <source>Permission denied</source>
        <translation>Permiso denegado</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Demasiados archivos abiertos</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>No existe el archivo o la carpeta</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>No queda espacio en el dispositivo</translation>
    </message>
    <message>
        <source>file to open is a directory</source>
        <translation>es una carpeta, no un archivo</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Seleccionar todo</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>Mostrar los detalles…</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Ocultar los detalles…</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Sí</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Sí a &amp;todo</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;No</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>N&amp;o a todo</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Guardar todo</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Interrumpir</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Reintentar</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Valores predeterminados</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
</context>
<context>
    <name>QSaveFile</name>
    <message>
        <source>Existing file %1 is not writable</source>
        <translation>El archivo %1 ya existe y no se puede modificar</translation>
    </message>
    <message>
        <source>Filename refers to a directory</source>
        <translation>El nombre es el de una carpeta</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Desplazar hasta aquí</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Borde izquierdo</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba del todo</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Borde derecho</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Abajo del todo</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Página a la izquierda</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Página anterior</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Página a la derecha</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Página siguiente</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Desplazar a la izquierda</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Desplazar hacia arriba</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Desplazar a la derecha</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Desplazar hacia abajo</translation>
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
        <translation>Mayús</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>←</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>→</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>↑</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>↓</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>RePág</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>AvPág</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Retroceder página</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Avanzar página</translation>
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
        <translation>Insertar</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Suprimir</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backtab</source>
        <translation>Mayús+Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Media Play</source>
        <translation>Reproducir</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Desplazar a la izquierda</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Desplazar a la derecha</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>Copiar la dirección del en&amp;lace</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Seleccionar todo</translation>
    </message>
</context>
<context>
    <name>app::Arguments</name>
    <message>
        <source>stands twice</source>
        <translation>aparece dos veces</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>argumento inesperado «%1»</translation>
    </message>
    <message>
        <source>must be a number, got &quot;%1&quot;</source>
        <translation>se esperaba un número, no «%1»</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>debe ser un nombre</translation>
    </message>
</context>
<context>
    <name>app::CsvOutput</name>
    <message>
        <source>standard output</source>
        <translation>salida estándar</translation>
    </message>
</context>
<context>
    <name>app::Demonstration</name>
    <message>
        <source>every method diverged before %1 s</source>
        <translation>todos los métodos divergieron antes de %1 s</translation>
    </message>
    <message>
        <source>There is no display for the window, so &quot;%1&quot; was simulated for %2 s.
%3: energy with %4
%5: where every weight is, with %6
%7: the scene at %8 s
</source>
        <translation>No hay pantalla para la ventana: se simuló «%1» durante %2 s.
%3: la energía con %4
%5: dónde está cada pesa, con %6
%7: la escena a los %8 s
</translation>
    </message>
    <message>
        <source> and </source>
        <translation> y </translation>
    </message>
</context>
<context>
    <name>app::EnergyHistory</name>
    <message>
        <source>Time in s; energies in J: kinetic, potential, lost to air, to impacts, to ropes, to friction; numerical drift
</source>
        <translation>Tiempo en s; energías en J: cinética, potencial, perdida en el aire, en choques, en cuerdas, por rozamiento; deriva numérica
</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>cinética</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potencial</translation>
    </message>
    <message>
        <source>air</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>impacts</source>
        <translation>choques</translation>
    </message>
    <message>
        <source>ropes</source>
        <translation>cuerdas</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>rozamiento</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>deriva</translation>
    </message>
</context>
<context>
    <name>app::ExitStatus</name>
    <message>
        <source>standard output: %1</source>
        <translation>salida estándar: %1</translation>
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
        <translation>Uso:
  angrycuts [ESCENA]                     abre la ventana
  angrycuts scenes [--export CARPETA]    lista las escenas incluidas, o las
                                         escribe como archivos
  angrycuts simulate ESCENA [opciones]   calcula sin ventana
  angrycuts measure ESCENA [opciones]    mide la velocidad y la precisión
  angrycuts --help, --version

Una ESCENA es un archivo o el nombre de una escena incluida. Si no hay
pantalla, angrycuts [ESCENA] simula la escena con cada uno de sus métodos y
escribe los resultados en la carpeta actual.

Opciones de simulate:
  --method NOMBRE       %1 (rk4)
  --step SEGUNDOS       paso del método, de 1e-7 a 10 (1/60)
  --tolerance X         en vez de un paso para dopri5, de 1e-14 a 1 (1e-9)
  --until SEGUNDOS      tiempo simulado que alcanzar, de 0 a 1e6 (10)
  --cut SEGUNDOS|never  cuándo se cortan todas las cuerdas (según la escena)
  --sample SEGUNDOS     tiempo entre filas, de 1e-7 a 1e6 (0.1)
  --trajectory ARCHIVO  dónde está cada pesa, como CSV; -: salida estándar
  --energy ARCHIVO      dónde está la energía, como CSV; -: salida estándar
  --events ARCHIVO      qué ocurrió, como CSV; -: salida estándar
  --chart ARCHIVO       el gráfico de energía como .png, .svg o .pdf
Sin ninguno de los cuatro archivos muestra una tabla breve.

Opciones de measure, que prueba todos los métodos con muchos pasos:
  --until SEGUNDOS      tiempo simulado que medir, de 0 a 1e6 (10)
  --cut SEGUNDOS|never  cuándo se cortan todas las cuerdas (según la escena)
  --csv ARCHIVO         todas las cifras, como CSV; -: salida estándar
  --chart ARCHIVO       el error según el coste como .png, .svg o .pdf
Sin ninguno de los dos archivos muestra una tabla breve.

Código de salida: 0; 2 si se rechaza la llamada o la escena; 3 si los números,
o los eventos o pasos dentro de un paso, se descontrolan; 1 para todo lo
demás, como un disco lleno.
</translation>
    </message>
</context>
<context>
    <name>app::MeasureTable</name>
    <message>
        <source>at most</source>
        <translation>como máximo</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <translation>extrapolado</translation>
    </message>
    <message>
        <source>method</source>
        <translation>método</translation>
    </message>
    <message>
        <source>order</source>
        <translation>orden</translation>
    </message>
    <message>
        <source>least error</source>
        <translation>error mínimo</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>ajuste</translation>
    </message>
    <message>
        <source>ns per s</source>
        <translation>ns por s</translation>
    </message>
    <message>
        <source>Order: the power of the step that the position error falls with. Setting (step in s, or tolerance)
and cost (ns of computing per simulated second): to be right within 1e-6 m.

</source>
        <translation>Orden: la potencia del paso con la que disminuye el error de posición. Ajuste (paso en s, o
tolerancia) y coste (ns de cálculo por segundo simulado): para un error de 1e-6 m como máximo.

</translation>
    </message>
</context>
<context>
    <name>app::Options</name>
    <message>
        <source>%1 is used twice</source>
        <translation>%1 se usa dos veces</translation>
    </message>
    <message>
        <source>must end in .png, .svg or .pdf, got &quot;%1&quot;</source>
        <translation>debe terminar en .png, .svg o .pdf, no «%1»</translation>
    </message>
    <message>
        <source>%1: a scene must be named</source>
        <translation>%1: hay que nombrar una escena</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;</source>
        <translation>comando desconocido «%1»</translation>
    </message>
    <message>
        <source>must be one of %1, got &quot;%2&quot;</source>
        <translation>se esperaba uno de %1, no «%2»</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 usa una tolerancia, no un paso</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 usa un paso, no una tolerancia</translation>
    </message>
</context>
<context>
    <name>app::ProgressLine</name>
    <message>
        <source>Measuring: %1 %</source>
        <translation>Midiendo: %1 %</translation>
    </message>
</context>
<context>
    <name>app::ScenesCommand</name>
    <message>
        <source>%1: the folder cannot be made</source>
        <translation>%1: no se puede crear la carpeta</translation>
    </message>
</context>
<context>
    <name>app::SimulateCommand</name>
    <message>
        <source>a larger --tolerance may help</source>
        <translation>un valor mayor de --tolerance puede ayudar</translation>
    </message>
    <message>
        <source>a smaller --tolerance may help</source>
        <translation>un valor menor de --tolerance puede ayudar</translation>
    </message>
    <message>
        <source>a smaller --step may help</source>
        <translation>un valor menor de --step puede ayudar</translation>
    </message>
    <message>
        <source>--step %1 works</source>
        <translation>--step %1 funciona</translation>
    </message>
    <message>
        <source>the numbers stopped being finite</source>
        <translation>los números dejaron de ser finitos</translation>
    </message>
    <message>
        <source>the next step holds more events than can be followed</source>
        <translation>el paso siguiente contiene más eventos de los que se pueden seguir</translation>
    </message>
    <message>
        <source>the tolerance asks for more or smaller steps than can be taken</source>
        <translation>la tolerancia exige más pasos o más pequeños de lo posible</translation>
    </message>
    <message>
        <source>diverged at %1 s: %2; %3</source>
        <translation>diverge a los %1 s: %2; %3</translation>
    </message>
</context>
<context>
    <name>app::main</name>
    <message>
        <source>the window cannot be opened: %1</source>
        <translation>no se puede abrir la ventana: %1</translation>
    </message>
    <message>
        <source>no display answers (%1)</source>
        <translation>no responde ninguna pantalla (%1)</translation>
    </message>
</context>
<context>
    <name>ui::AccuracyPanel</name>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Tiempo simulado</translation>
    </message>
    <message>
        <source>Error against cost</source>
        <translation>Error según el coste</translation>
    </message>
    <message>
        <source>Error against step</source>
        <translation>Error según el paso</translation>
    </message>
    <message>
        <source>What the chart shows</source>
        <translation>Lo que muestra el gráfico</translation>
    </message>
    <message>
        <source>Right within</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source>Error against cost or step</source>
        <translation>Error según el coste o el paso</translation>
    </message>
    <message>
        <source>Click a point to open it as a run</source>
        <translation>Haga clic en un punto para abrirlo como simulación</translation>
    </message>
    <message>
        <source>Measures every method at steps from 1/8 to 1/8192 s: how far the weights are from where they really are, and what that costs. Takes some seconds.</source>
        <translation>Mide cada método con pasos de 1/8 a 1/8192 s: a qué distancia están las pesas de su posición real y cuánto cuesta. Tarda unos segundos.</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>precision</translation>
    </message>
    <message>
        <source>How long each run is followed, in s; errors are compared at its end</source>
        <translation>Cuánto se sigue cada simulación, en s; los errores se comparan al final</translation>
    </message>
    <message>
        <source>Cost is counted in slope evaluations, which the time of computing goes with</source>
        <translation>El coste se cuenta en evaluaciones de pendiente, que sigue el tiempo de cálculo</translation>
    </message>
    <message>
        <source>Largest distance from the true place that is accepted, in m: which method reaches it at the lowest cost?</source>
        <translation>Mayor distancia aceptada al lugar verdadero, en m: ¿qué método la alcanza al menor coste?</translation>
    </message>
</context>
<context>
    <name>ui::BuiltInScenes</name>
    <message>
        <source>no file or built-in scene of that name</source>
        <translation>no hay archivo ni escena incluida con ese nombre</translation>
    </message>
</context>
<context>
    <name>ui::ChartFile</name>
    <message>
        <source>a chart&apos;s file ends in .png, .svg or .pdf</source>
        <translation>el archivo de un gráfico termina en .png, .svg o .pdf</translation>
    </message>
</context>
<context>
    <name>ui::ChartKind</name>
    <message>
        <source>Energy</source>
        <translation>Energía</translation>
    </message>
    <message>
        <source>Energies over time</source>
        <translation>Energías a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Ledger</source>
        <translation>Balance</translation>
    </message>
    <message>
        <source>Where the energy is and went, stacked</source>
        <translation>Dónde está la energía y adónde fue, apilado</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Phase portrait: angular velocity against angle</source>
        <translation>Retrato de fase: velocidad angular según el ángulo</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Trayectorias</translation>
    </message>
    <message>
        <source>Paths of the weights: y against x</source>
        <translation>Trayectorias de las pesas: y según x</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Height above the floor over time</source>
        <translation>Altura sobre el suelo a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Speed over time</source>
        <translation>Velocidad a lo largo del tiempo</translation>
    </message>
</context>
<context>
    <name>ui::ChartOverlay</name>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
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
        <translation>Ancho de página</translation>
    </message>
    <message>
        <source>Half the page width</source>
        <translation>Medio ancho de página</translation>
    </message>
    <message>
        <source>Slide, 16:9</source>
        <translation>Diapositiva, 16:9</translation>
    </message>
    <message>
        <source>Poster, A3</source>
        <translation>Póster, A3</translation>
    </message>
    <message>
        <source>Size of the chart</source>
        <translation>Tamaño del gráfico</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Tamaño propio</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Para</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Ancho</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>A&amp;lto</translation>
    </message>
    <message>
        <source>Sizes that are often wanted</source>
        <translation>Tamaños que se usan a menudo</translation>
    </message>
    <message>
        <source>Width of the chart on paper, in mm</source>
        <translation>Ancho del gráfico en papel, en mm</translation>
    </message>
    <message>
        <source>Height of the chart on paper, in mm</source>
        <translation>Alto del gráfico en papel, en mm</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
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
        <translation>Tiempo</translation>
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
        <translation>Un clic va a un instante. La rueda, más y menos amplían, un recuadro también; Alt y las flechas mueven el gráfico, 0 lo muestra entero.</translation>
    </message>
</context>
<context>
    <name>ui::ChartsPanel</name>
    <message>
        <source>Kind of chart</source>
        <translation>Tipo de gráfico</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Pesa </translation>
    </message>
    <message>
        <source>Weight in the chart</source>
        <translation>Pesa del gráfico</translation>
    </message>
    <message>
        <source>Weight in the chart, counted from the left; 0: all</source>
        <translation>Pesa del gráfico, contada desde la izquierda; 0: todas</translation>
    </message>
    <message>
        <source>Runs in the chart</source>
        <translation>Simulaciones del gráfico</translation>
    </message>
    <message>
        <source>Chart menu</source>
        <translation>Menú del gráfico</translation>
    </message>
    <message>
        <source>Zoom, copy, export, hide curves</source>
        <translation>Zoom, copiar, exportar, ocultar curvas</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>C&amp;urvas</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>What the chart shows against what</source>
        <translation>Qué muestra el gráfico frente a qué</translation>
    </message>
</context>
<context>
    <name>ui::Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>Start with one weight in an empty room</source>
        <translation>Empezar con una pesa en una sala vacía</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>Abrir un archivo de escena</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Lecciones…</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Choose one of the built-in scenes by its picture</source>
        <translation>Elegir una de las escenas incluidas por su imagen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Guardar la escena</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Save the scene in another file</source>
        <translation>Guardar la escena en otro archivo</translation>
    </message>
    <message>
        <source>&amp;Export chart…</source>
        <translation>&amp;Exportar gráfico…</translation>
    </message>
    <message>
        <source>Save the chart as a PNG, SVG or PDF picture</source>
        <translation>Guardar el gráfico como imagen PNG, SVG o PDF</translation>
    </message>
    <message>
        <source>Export &amp;picture of the scene…</source>
        <translation>Exportar i&amp;magen…</translation>
    </message>
    <message>
        <source>Save what is shown as a PNG, SVG or PDF picture</source>
        <translation>Guardar lo que se muestra como imagen PNG, SVG o PDF</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change of the scene</source>
        <translation>Deshacer el último cambio de la escena</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Make the change again that was taken back last</source>
        <translation>Volver a hacer el último cambio deshecho</translation>
    </message>
    <message>
        <source>&amp;Weights table</source>
        <translation>&amp;Tabla de pesas</translation>
    </message>
    <message>
        <source>All weights in a table, to be changed many at once</source>
        <translation>Todas las pesas en una tabla, para cambiar muchas a la vez</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Reproducir</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Let time pass, or stop it</source>
        <translation>Dejar pasar el tiempo, o detenerlo</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Avanzar un paso</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Take one integration step of the first run</source>
        <translation>Dar un paso de integración de la primera simulación</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>Re&amp;troceder un paso</translation>
    </message>
    <message>
        <source>Go back by one integration step of the first run</source>
        <translation>Retroceder un paso de integración de la primera simulación</translation>
    </message>
    <message>
        <source>Step one &amp;frame</source>
        <translation>Un &amp;fotograma adelante</translation>
    </message>
    <message>
        <source>Go on by 1/60 s, times the speed</source>
        <translation>Avanzar 1/60 s, multiplicado por la velocidad</translation>
    </message>
    <message>
        <source>Step a f&amp;rame back</source>
        <translation>Un foto&amp;grama atrás</translation>
    </message>
    <message>
        <source>Go back by 1/60 s, times the speed</source>
        <translation>Retroceder 1/60 s, multiplicado por la velocidad</translation>
    </message>
    <message>
        <source>&amp;Cut the ropes</source>
        <translation>&amp;Cortar las cuerdas</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Cut all ropes now</source>
        <translation>Cortar ahora todas las cuerdas</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Rei&amp;niciar</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Go back to the start</source>
        <translation>Volver al inicio</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Más &amp;lento</translation>
    </message>
    <message>
        <source>Halve the speed</source>
        <translation>Reducir la velocidad a la mitad</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>Más rápi&amp;do</translation>
    </message>
    <message>
        <source>Double the speed</source>
        <translation>Duplicar la velocidad</translation>
    </message>
    <message>
        <source>Split &amp;views</source>
        <translation>&amp;Vistas separadas</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Give each run a view of its own</source>
        <translation>Dar a cada simulación su propia vista</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>Evento &amp;siguiente</translation>
    </message>
    <message>
        <source>Go to the next event of any kind</source>
        <translation>Ir al siguiente evento de cualquier tipo</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>Evento &amp;anterior</translation>
    </message>
    <message>
        <source>Go back to the event before</source>
        <translation>Volver al evento anterior</translation>
    </message>
    <message>
        <source>Next &amp;impact</source>
        <translation>&amp;Choque siguiente</translation>
    </message>
    <message>
        <source>Go on until something is hit</source>
        <translation>Avanzar hasta el siguiente choque</translation>
    </message>
    <message>
        <source>Previous i&amp;mpact</source>
        <translation>C&amp;hoque anterior</translation>
    </message>
    <message>
        <source>Go back to the impact before</source>
        <translation>Volver al choque anterior</translation>
    </message>
    <message>
        <source>Next &amp;turning point</source>
        <translation>&amp;Retorno siguiente</translation>
    </message>
    <message>
        <source>Go on until a weight turns round on its rope</source>
        <translation>Avanzar hasta que una pesa cambie de sentido en su cuerda</translation>
    </message>
    <message>
        <source>Previous t&amp;urning point</source>
        <translation>Retorno a&amp;nterior</translation>
    </message>
    <message>
        <source>Go back to the turning point before</source>
        <translation>Volver al punto de retorno anterior</translation>
    </message>
    <message>
        <source>Next &amp;cut</source>
        <translation>C&amp;orte siguiente</translation>
    </message>
    <message>
        <source>Go on until ropes are cut</source>
        <translation>Avanzar hasta que se corten cuerdas</translation>
    </message>
    <message>
        <source>Previous cu&amp;t</source>
        <translation>Cor&amp;te anterior</translation>
    </message>
    <message>
        <source>Go back to the cut before</source>
        <translation>Volver al corte anterior</translation>
    </message>
    <message>
        <source>&amp;Start of the recording</source>
        <translation>&amp;Inicio de la grabación</translation>
    </message>
    <message>
        <source>Show the start again; what is recorded stays</source>
        <translation>Mostrar otra vez el inicio; lo grabado se conserva</translation>
    </message>
    <message>
        <source>&amp;End of the recording</source>
        <translation>&amp;Fin de la grabación</translation>
    </message>
    <message>
        <source>Show the last moment that is computed</source>
        <translation>Mostrar el último instante calculado</translation>
    </message>
    <message>
        <source>&amp;Go to a time…</source>
        <translation>Ir a &amp;un instante…</translation>
    </message>
    <message>
        <source>Show any moment, and compute it first where needed</source>
        <translation>Mostrar cualquier instante, calculándolo antes si hace falta</translation>
    </message>
    <message>
        <source>Stop &amp;on the way</source>
        <translation>&amp;Detenerse en el camino</translation>
    </message>
    <message>
        <source>Stay at the moment that the computing has come to</source>
        <translation>Quedarse en el instante al que ha llegado el cálculo</translation>
    </message>
    <message>
        <source>Speed and &amp;accuracy…</source>
        <translation>&amp;Velocidad y precisión…</translation>
    </message>
    <message>
        <source>Measure what accuracy costs, and how large steps may be</source>
        <translation>Medir cuánto cuesta la precisión y qué tamaño pueden tener los pasos</translation>
    </message>
    <message>
        <source>&amp;When to cut?…</source>
        <translation>¿C&amp;uándo cortar?…</translation>
    </message>
    <message>
        <source>Find the moments to cut at that hit the target</source>
        <translation>Hallar los instantes de corte que dan en la diana</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>&amp;Estelas</translation>
    </message>
    <message>
        <source>Show where the weights have just been</source>
        <translation>Mostrar por dónde acaban de pasar las pesas</translation>
    </message>
    <message>
        <source>V&amp;elocities</source>
        <translation>Ve&amp;locidades</translation>
    </message>
    <message>
        <source>Show how fast the weights move, and where to, as arrows</source>
        <translation>Mostrar con flechas a qué velocidad y hacia dónde van las pesas</translation>
    </message>
    <message>
        <source>Fo&amp;rces</source>
        <translation>&amp;Fuerzas</translation>
    </message>
    <message>
        <source>Show gravity, air drag and the pull of the rope as arrows</source>
        <translation>Mostrar con flechas el peso, la resistencia del aire y la tensión de la cuerda</translation>
    </message>
    <message>
        <source>Te&amp;nsions</source>
        <translation>&amp;Tensiones</translation>
    </message>
    <message>
        <source>Show in newtons how hard each rope pulls</source>
        <translation>Mostrar en newtons la tensión de cada cuerda</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Regla</translation>
    </message>
    <message>
        <source>Measure a length in the scene</source>
        <translation>Medir una longitud en la escena</translation>
    </message>
    <message>
        <source>&amp;Protractor</source>
        <translation>&amp;Transportador</translation>
    </message>
    <message>
        <source>Measure an angle in the scene</source>
        <translation>Medir un ángulo en la escena</translation>
    </message>
    <message>
        <source>&amp;Stopwatch</source>
        <translation>&amp;Cronómetro</translation>
    </message>
    <message>
        <source>Measure simulated time</source>
        <translation>Medir el tiempo simulado</translation>
    </message>
    <message>
        <source>S&amp;tart or stop the stopwatch</source>
        <translation>&amp;Iniciar/parar cronómetro</translation>
    </message>
    <message>
        <source>Start the stopwatch at the moment shown, or stop it</source>
        <translation>Iniciar el cronómetro en el instante mostrado, o pararlo</translation>
    </message>
    <message>
        <source>Stopwatch to &amp;zero</source>
        <translation>Cronómetro a c&amp;ero</translation>
    </message>
    <message>
        <source>Set the stopwatch back to zero</source>
        <translation>Poner el cronómetro a cero</translation>
    </message>
    <message>
        <source>&amp;Next handle</source>
        <translation>Tirador &amp;siguiente</translation>
    </message>
    <message>
        <source>Choose what Alt and the arrow keys move: an end of the ruler, an arm of the protractor …</source>
        <translation>Elegir qué mueven Alt y las flechas: un extremo de la regla, un brazo del transportador…</translation>
    </message>
    <message>
        <source>Tar&amp;get</source>
        <translation>&amp;Diana</translation>
    </message>
    <message>
        <source>Show a target on the floor; drag it to where it shall be</source>
        <translation>Mostrar una diana en el suelo; arrástrela a donde deba estar</translation>
    </message>
    <message>
        <source>&amp;Lesson text</source>
        <translation>Texto de la lecc&amp;ión</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>Show what to look for and what to try, or hide it</source>
        <translation>Mostrar qué observar y qué probar, u ocultarlo</translation>
    </message>
    <message>
        <source>&amp;Fit the room</source>
        <translation>Encuadrar la &amp;sala</translation>
    </message>
    <message>
        <source>Show the whole room</source>
        <translation>Mostrar toda la sala</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Acercar</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ale&amp;jar</translation>
    </message>
    <message>
        <source>&amp;Next weight</source>
        <translation>Pesa &amp;siguiente</translation>
    </message>
    <message>
        <source>Select the next weight</source>
        <translation>Seleccionar la pesa siguiente</translation>
    </message>
    <message>
        <source>&amp;Previous weight</source>
        <translation>Pesa &amp;anterior</translation>
    </message>
    <message>
        <source>Select the weight before</source>
        <translation>Seleccionar la pesa anterior</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>No seleccionar &amp;nada</translation>
    </message>
    <message>
        <source>Select no weight and no handle any more</source>
        <translation>No seleccionar ya ni pesa ni tirador</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Mover a la &amp;izquierda</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the left, or move the weight or handle</source>
        <translation>Girar la cuerda de la pesa seleccionada hacia la izquierda, o mover la pesa o el tirador</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>Mover a la &amp;derecha</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the right, or move the weight or handle</source>
        <translation>Girar la cuerda de la pesa seleccionada hacia la derecha, o mover la pesa o el tirador</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Mover a&amp;rriba</translation>
    </message>
    <message>
        <source>Shorten the rope of the selected weight, or move the weight or handle up</source>
        <translation>Acortar la cuerda de la pesa seleccionada, o subir la pesa o el tirador</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Mover a&amp;bajo</translation>
    </message>
    <message>
        <source>Lengthen the rope of the selected weight, or move the weight or handle down</source>
        <translation>Alargar la cuerda de la pesa seleccionada, o bajar la pesa o el tirador</translation>
    </message>
    <message>
        <source>Faster l&amp;eft</source>
        <translation>Más rápido a la i&amp;zquierda</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the left</source>
        <translation>Aumentar hacia la izquierda la velocidad de la pesa seleccionada</translation>
    </message>
    <message>
        <source>Faster r&amp;ight</source>
        <translation>Más rápido a la dere&amp;cha</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the right</source>
        <translation>Aumentar hacia la derecha la velocidad de la pesa seleccionada</translation>
    </message>
    <message>
        <source>&amp;Faster up</source>
        <translation>Más rápido &amp;hacia arriba</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight upwards</source>
        <translation>Aumentar hacia arriba la velocidad de la pesa seleccionada</translation>
    </message>
    <message>
        <source>Fa&amp;ster down</source>
        <translation>Más rápid&amp;o hacia abajo</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight downwards</source>
        <translation>Aumentar hacia abajo la velocidad de la pesa seleccionada</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>P&amp;resentar</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Presentar</translation>
    </message>
    <message>
        <source>Fill the screen with the scene and one chart, in large type</source>
        <translation>Llenar la pantalla con la escena y un gráfico, en letra grande</translation>
    </message>
    <message>
        <source>&amp;Next chart</source>
        <translation>Gráfico &amp;siguiente</translation>
    </message>
    <message>
        <source>Show the next kind of chart</source>
        <translation>Mostrar el tipo de gráfico siguiente</translation>
    </message>
    <message>
        <source>&amp;Previous chart</source>
        <translation>Gráfico &amp;anterior</translation>
    </message>
    <message>
        <source>Show the previous kind of chart</source>
        <translation>Mostrar el tipo de gráfico anterior</translation>
    </message>
    <message>
        <source>&amp;Whole chart</source>
        <translation>Gráfico &amp;completo</translation>
    </message>
    <message>
        <source>Show all of the chart again after zooming</source>
        <translation>Mostrar otra vez todo el gráfico tras el zoom</translation>
    </message>
    <message>
        <source>&amp;Copy chart</source>
        <translation>Copiar &amp;gráfico</translation>
    </message>
    <message>
        <source>Copy the chart as a picture for paper</source>
        <translation>Copiar el gráfico como imagen para papel</translation>
    </message>
    <message>
        <source>Copy chart &amp;data</source>
        <translation>Copiar &amp;datos</translation>
    </message>
    <message>
        <source>Copy the chart&apos;s curves as a table for a spreadsheet</source>
        <translation>Copiar las curvas del gráfico como tabla para una hoja de cálculo</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Teclas</translation>
    </message>
    <message>
        <source>List all keys</source>
        <translation>Mostrar todas las teclas</translation>
    </message>
    <message>
        <source>&amp;About Angry Cuts</source>
        <translation>&amp;Acerca de Angry Cuts</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausa</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>&amp;Teacher&apos;s sheet</source>
        <translation>&amp;Hoja del profesor</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Hoja</translation>
    </message>
    <message>
        <source>Goal, steps, questions and expected figures of this lesson, to be printed</source>
        <translation>Objetivo, pasos, preguntas y valores esperados de esta lección, para imprimir</translation>
    </message>
    <message>
        <source>Quick &amp;guide</source>
        <translation>&amp;Guía rápida</translation>
    </message>
    <message>
        <source>Explain the window in a few pages</source>
        <translation>Explicar la ventana en unas pocas páginas</translation>
    </message>
    <message>
        <source>The &amp;model</source>
        <translation>El &amp;modelo</translation>
    </message>
    <message>
        <source>Show the equations that are computed, and why</source>
        <translation>Mostrar las ecuaciones que se calculan, y por qué</translation>
    </message>
    <message>
        <source>T&amp;our of the window</source>
        <translation>&amp;Recorrido por la ventana</translation>
    </message>
    <message>
        <source>Point out the five most important parts of the window</source>
        <translation>Señalar las cinco partes más importantes de la ventana</translation>
    </message>
</context>
<context>
    <name>ui::ComparisonPanel</name>
    <message>
        <source>Run that distances are measured from</source>
        <translation>Simulación desde la que se miden las distancias</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>Apart (m)</source>
        <translation>Dist. (m)</translation>
    </message>
    <message>
        <source>Drift (J)</source>
        <translation>Deriva (J)</translation>
    </message>
    <message>
        <source>Drift (%)</source>
        <translation>Deriva (%)</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Pendientes</translation>
    </message>
    <message>
        <source>The same as a share of the energy at the start</source>
        <translation>Lo mismo, como parte de la energía inicial</translation>
    </message>
    <message>
        <source>Slope evaluations so far</source>
        <translation>Evaluaciones de pendiente hasta ahora</translation>
    </message>
    <message>
        <source>Runs in figures</source>
        <translation>Las simulaciones en cifras</translation>
    </message>
    <message>
        <source>Distance from %1</source>
        <translation>Distancia a %1</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, now: max |p − p&apos;|, in m</source>
        <translation>Mayor distancia entre la misma pesa de ambas simulaciones, ahora: max |p − p’|, en m</translation>
    </message>
    <message>
        <source>Energy the method got wrong so far, in J: kinetic + potential + losses − energy at the start</source>
        <translation>Energía que el método ha falseado hasta ahora, en J: cinética + potencial + pérdidas − energía al inicio</translation>
    </message>
    <message>
        <source>Method and step of the run</source>
        <translation>Método y paso de la simulación</translation>
    </message>
    <message>
        <source>How far the runs are apart, and what each got wrong, at the moment shown</source>
        <translation>Cuánto se separan las simulaciones y qué falseó cada una, en el instante mostrado</translation>
    </message>
</context>
<context>
    <name>ui::CutQuestions</name>
    <message>
        <source>Cut between</source>
        <translation>Cortar entre</translation>
    </message>
    <message>
        <source>and</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Weight that is to hit the target</source>
        <translation>Pesa que debe dar en la diana</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Qué pesa, contada desde la izquierda</translation>
    </message>
    <message>
        <source>Method that finds the moments</source>
        <translation>Método que busca los instantes</translation>
    </message>
    <message>
        <source>Center of the target</source>
        <translation>Centro de la diana</translation>
    </message>
    <message>
        <source>Where the middle of the target lies, x in m from the left wall</source>
        <translation>Dónde está el centro de la diana, x en m desde la pared izquierda</translation>
    </message>
    <message>
        <source>Width of the target</source>
        <translation>Ancho de la diana</translation>
    </message>
    <message>
        <source>How wide the target is, in m</source>
        <translation>Ancho de la diana, en m</translation>
    </message>
    <message>
        <source>First cut time</source>
        <translation>Primer instante de corte</translation>
    </message>
    <message>
        <source>The earliest moment to cut, in s</source>
        <translation>El primer instante para cortar, en s</translation>
    </message>
    <message>
        <source>Last cut time</source>
        <translation>Último instante de corte</translation>
    </message>
    <message>
        <source>The latest moment to cut, in s</source>
        <translation>El último instante para cortar, en s</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Pesa</translation>
    </message>
    <message>
        <source>by</source>
        <translation>con</translation>
    </message>
    <message>
        <source>Target at</source>
        <translation>Diana en</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>must be later than the first</source>
        <translation>debe ser posterior al primero</translation>
    </message>
</context>
<context>
    <name>ui::CutResults</name>
    <message>
        <source>when-to-cut</source>
        <translation>cuando-cortar</translation>
    </message>
    <message>
        <source>Copy chart</source>
        <translation>Copiar gráfico</translation>
    </message>
    <message>
        <source>Copy chart data</source>
        <translation>Copiar datos</translation>
    </message>
    <message>
        <source>Finds where the weight first comes to the floor for every moment of the cut, and the moments that hit the target.</source>
        <translation>Busca, para cada instante del corte, dónde llega primero la pesa al suelo, y los instantes que dan en la diana.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweep</name>
    <message>
        <source>straight to the floor</source>
        <translation>directo al suelo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Weight %1 never comes to the floor.</source>
        <translation>La pesa %1 nunca llega al suelo.</translation>
    </message>
    <message>
        <source>No cut makes weight %1 hit the target. The nearest is %2 m off, cut at %3 s.</source>
        <translation>Ningún corte hace que la pesa %1 dé en la diana. Lo más cerca que cae es a %2 m, cortada a los %3 s.</translation>
    </message>
    <message>
        <source>off a wall</source>
        <translation>rebota en una pared</translation>
    </message>
    <message>
        <source>off a weight</source>
        <translation>rebota en una pesa</translation>
    </message>
    <message>
        <source>Weight %1, %2</source>
        <translation>Pesa %1, %2</translation>
    </message>
    <message>
        <source>; the run cannot go on to the end</source>
        <translation>; la simulación no puede llegar al final</translation>
    </message>
    <message>
        <source>; there are more jumps than can be told apart</source>
        <translation>; hay más saltos de los que se pueden distinguir</translation>
    </message>
    <message>
        <source>Of the cut times from %1 s to %2 s, %3 % hit the target. Click the chart, or double-click a row, to cut then.</source>
        <translation>De los instantes de corte de %1 s a %2 s, el %3 % da en la diana. Haga clic en el gráfico, o doble clic en una fila, para cortar entonces.</translation>
    </message>
    <message>
        <source>Cut (s)</source>
        <translation>Corte (s)</translation>
    </message>
    <message>
        <source>Lands at (m)</source>
        <translation>Punto de caída (m)</translation>
    </message>
    <message>
        <source>Landing (s)</source>
        <translation>Llegada (s)</translation>
    </message>
    <message>
        <source>On the way</source>
        <translation>Por el camino</translation>
    </message>
    <message>
        <source>On the target</source>
        <translation>En la diana</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepChart</name>
    <message>
        <source>Landing place against cut time</source>
        <translation>Punto de caída según el instante del corte</translation>
    </message>
    <message>
        <source>cut at %1 s</source>
        <translation>corte a los %1 s</translation>
    </message>
    <message>
        <source>does not land</source>
        <translation>no llega al suelo</translation>
    </message>
    <message>
        <source>lands at %1 m</source>
        <translation>cae a %1 m</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>tras %1 s</translation>
    </message>
    <message>
        <source>A click cuts the ropes at that moment; moments that hit are listed in the table beside it.</source>
        <translation>Un clic corta las cuerdas en ese instante; los instantes que aciertan están en la tabla de al lado.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepPlot</name>
    <message>
        <source>target</source>
        <translation>diana</translation>
    </message>
    <message>
        <source>hits it</source>
        <translation>acierta</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Instante del corte</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Lands at</source>
        <translation>Punto de caída</translation>
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
        <translation>Buscar</translation>
    </message>
    <message>
        <source>When to cut?</source>
        <translation>¿Cuándo cortar?</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>cambio del corte</translation>
    </message>
    <message>
        <source>All ropes are cut at %1 s now. Play to see where weight %2 lands.</source>
        <translation>Ahora todas las cuerdas se cortan a los %1 s. Reproduzca para ver dónde cae la pesa %2.</translation>
    </message>
</context>
<context>
    <name>ui::DraftKeeper</name>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>no se puede crear la carpeta %1</translation>
    </message>
    <message>
        <source>nothing can be written to %1</source>
        <translation>no se puede escribir en %1</translation>
    </message>
</context>
<context>
    <name>ui::EnergyChart</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energía</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>drift %1 J</source>
        <translation>deriva %1 J</translation>
    </message>
    <message>
        <source>drift %1 J (%2 %)</source>
        <translation>deriva %1 J (%2 %)</translation>
    </message>
    <message>
        <source>drift %1 J (%1 %)</source>
        <translation>deriva %1 J (%1 %)</translation>
    </message>
    <message>
        <source>%1 reaches %2 J</source>
        <translation>%1 alcanza %2 J</translation>
    </message>
    <message>
        <source>Scale ends at %1 %2: %3.</source>
        <translation>La escala termina en %1 %2: %3.</translation>
    </message>
    <message>
        <source> − %1 %2</source>
        <translation> − %1 %2</translation>
    </message>
    <message>
        <source>Numerical drift</source>
        <translation>Deriva numérica</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Al inicio</translation>
    </message>
    <message>
        <source>Kinetic</source>
        <translation>Cinética</translation>
    </message>
    <message>
        <source>Potential</source>
        <translation>Potencial</translation>
    </message>
    <message>
        <source>Lost to air</source>
        <translation>Perdida en el aire</translation>
    </message>
    <message>
        <source>Lost to impacts</source>
        <translation>Perdida en choques</translation>
    </message>
    <message>
        <source>Lost to ropes</source>
        <translation>Perdida en cuerdas</translation>
    </message>
    <message>
        <source>Lost to friction</source>
        <translation>Perdida por rozamiento</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
</context>
<context>
    <name>ui::EventNavigator</name>
    <message>
        <source>%1: none between %2 s and %3 s.</source>
        <translation>%1: nada entre %2 s y %3 s.</translation>
    </message>
</context>
<context>
    <name>ui::EventTable</name>
    <message>
        <source>Time (s)</source>
        <translation>Tiempo (s)</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Pesa</translation>
    </message>
    <message>
        <source>Before (m/s)</source>
        <translation>Antes (m/s)</translation>
    </message>
    <message>
        <source>After (m/s)</source>
        <translation>Después (m/s)</translation>
    </message>
    <message>
        <source>Energy lost (J)</source>
        <translation>Pérdida (J)</translation>
    </message>
    <message>
        <source>When it happened, t in s</source>
        <translation>Cuándo ocurrió, t en s</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Qué ocurrió</translation>
    </message>
    <message>
        <source>The weights it happened to, counted from the left</source>
        <translation>Las pesas a las que les ocurrió, contadas desde la izquierda</translation>
    </message>
    <message>
        <source>Speed |v| right before, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Velocidad |v| justo antes, en m/s. De la pesa; si chocan dos, de la primera nombrada</translation>
    </message>
    <message>
        <source>Speed |v| right after, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Velocidad |v| justo después, en m/s. De la pesa; si chocan dos, de la primera nombrada</translation>
    </message>
    <message>
        <source>Kinetic energy turned into heat by the event, in J. Between two weights ½ (1 − e²) μ v², with the speed v towards each other and 1/μ = 1/m₁ + 1/m₂</source>
        <translation>Energía cinética que el evento convierte en calor, en J. Entre dos pesas ½ (1 − e²) μ v², con la velocidad de acercamiento v y 1/μ = 1/m₁ + 1/m₂</translation>
    </message>
</context>
<context>
    <name>ui::EventWords</name>
    <message>
        <source>All events</source>
        <translation>Todos los eventos</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Choques</translation>
    </message>
    <message>
        <source>Turning points</source>
        <translation>Puntos de retorno</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Ropes slack and taut</source>
        <translation>Cuerdas destensadas y tensas</translation>
    </message>
    <message>
        <source>Coming to rest</source>
        <translation>Llegadas al reposo</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Turning point</source>
        <translation>Punto de retorno</translation>
    </message>
    <message>
        <source>Rope slack</source>
        <translation>Cuerda destensada</translation>
    </message>
    <message>
        <source>Rope taut</source>
        <translation>Cuerda tensa</translation>
    </message>
    <message>
        <source>Impact on the floor</source>
        <translation>Choque con el suelo</translation>
    </message>
    <message>
        <source>Impact on the ceiling</source>
        <translation>Choque con el techo</translation>
    </message>
    <message>
        <source>Impact on the left wall</source>
        <translation>Choque con pared izquierda</translation>
    </message>
    <message>
        <source>Impact on the right wall</source>
        <translation>Choque con pared derecha</translation>
    </message>
    <message>
        <source>Impact of weights</source>
        <translation>Choque de pesas</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>Llegada al reposo</translation>
    </message>
    <message>
        <source>all</source>
        <translation>todas</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
</context>
<context>
    <name>ui::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Kinds of events</source>
        <translation>Tipos de eventos que se muestran</translation>
    </message>
    <message>
        <source>Weight whose events are listed</source>
        <translation>Pesa cuyos eventos se listan</translation>
    </message>
    <message>
        <source>Weight whose events are listed, counted from the left</source>
        <translation>Pesa cuyos eventos se listan, contada desde la izquierda</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Pesa </translation>
    </message>
    <message>
        <source>Run whose events are listed</source>
        <translation>Simulación cuyos eventos se listan</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Copiar como CSV</translation>
    </message>
    <message>
        <source>Copy the chosen events as CSV, or all that are listed (Ctrl+C)</source>
        <translation>Copiar como CSV los eventos elegidos, o todos los de la lista (Ctrl+C)</translation>
    </message>
    <message>
        <source>Events copied as CSV: %1</source>
        <translation>Eventos copiados como CSV: %1</translation>
    </message>
    <message>
        <source>What happened in the run; choosing an event shows its moment</source>
        <translation>Qué ocurrió en la simulación; al elegir un evento se muestra su instante</translation>
    </message>
    <message>
        <source>Kinds of events that are listed</source>
        <translation>Tipos de eventos que se muestran</translation>
    </message>
</context>
<context>
    <name>ui::ExportButton</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Save the chart as a picture or its figures as a table</source>
        <translation>Guardar el gráfico como imagen o sus cifras como tabla</translation>
    </message>
    <message>
        <source>Chart…</source>
        <translation>Gráfico…</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Exportar gráfico</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabla…</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Exportar tabla</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::Exports</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Imagen PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Dibujo SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Documento PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Exportar gráfico</translation>
    </message>
    <message>
        <source>Export picture of the scene</source>
        <translation>Exportar imagen de la escena</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>escena</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energia</translation>
    </message>
    <message>
        <source>Export energy ledger</source>
        <translation>Exportar balance de energía</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 guardado</translation>
    </message>
    <message>
        <source>Not exported</source>
        <translation>No exportado</translation>
    </message>
    <message>
        <source>%1 was not written:
%2</source>
        <translation>No se escribió %1:
%2</translation>
    </message>
</context>
<context>
    <name>ui::FileDialog</name>
    <message>
        <source>scene</source>
        <translation>escena</translation>
    </message>
</context>
<context>
    <name>ui::FirstScene</name>
    <message>
        <source>The scene of last time, %1, was not opened: %2</source>
        <translation>No se abrió la escena de la última vez, %1: %2</translation>
    </message>
</context>
<context>
    <name>ui::Form</name>
    <message>
        <source>change of %1</source>
        <translation>cambio de %1</translation>
    </message>
</context>
<context>
    <name>ui::HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>About Angry Cuts</source>
        <translation>Acerca de Angry Cuts</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Weights hang on ropes and swing; the ropes are cut; the weights fly, bounce and come to rest. Two numerical methods compute the same scene side by side, and an energy ledger shows what each of them gets wrong.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Unas pesas cuelgan de cuerdas y oscilan; se cortan las cuerdas; las pesas vuelan, rebotan y quedan en reposo. Dos métodos numéricos calculan la misma escena en paralelo, y un balance de energía muestra en qué se equivoca cada uno.&lt;/p&gt;&lt;p&gt;Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Quick guide</source>
        <translation>Guía rápida</translation>
    </message>
    <message>
        <source>The model</source>
        <translation>El modelo</translation>
    </message>
    <message>
        <source>Teacher&apos;s sheets</source>
        <translation>Hojas del profesor</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Capítulos</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimir…</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Guardar como PDF…</translation>
    </message>
    <message>
        <source>Printed %1</source>
        <translation>%1 impreso</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Guardar como PDF</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Documento PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 guardado</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>No guardado</translation>
    </message>
    <message>
        <source>Guide, model or teacher&apos;s sheets</source>
        <translation>Guía, modelo u hojas del profesor</translation>
    </message>
    <message>
        <source>What this chapter has; the one chosen is shown</source>
        <translation>Lo que contiene este capítulo; se muestra lo elegido</translation>
    </message>
    <message>
        <source>The page that is open</source>
        <translation>La página abierta</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
    <message>
        <source>Print these pages, black on white</source>
        <translation>Imprimir estas páginas, en negro sobre blanco</translation>
    </message>
    <message>
        <source>Save these pages as a file</source>
        <translation>Guardar estas páginas en un archivo</translation>
    </message>
</context>
<context>
    <name>ui::HitTable</name>
    <message>
        <source>wall</source>
        <translation>pared</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>pesa</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Lands</source>
        <translation>Llegada</translation>
    </message>
    <message>
        <source>Off a</source>
        <translation>Rebote</translation>
    </message>
    <message>
        <source>The moment that comes nearest to the target&apos;s center</source>
        <translation>El instante que más se acerca al centro de la diana</translation>
    </message>
    <message>
        <source>How long the stretch of cut times is that hit</source>
        <translation>Duración del intervalo de instantes de corte que aciertan</translation>
    </message>
    <message>
        <source>When the weight lands</source>
        <translation>Cuándo llega la pesa al suelo</translation>
    </message>
    <message>
        <source>What it hits first, before the floor</source>
        <translation>Con qué choca primero, antes del suelo</translation>
    </message>
    <message>
        <source>Moments that hit</source>
        <translation>Instantes que aciertan</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to cut then</source>
        <translation>Haga doble clic en una fila, o pulse Intro, para cortar entonces</translation>
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
        <translation>línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>the text ends where a value must stand</source>
        <translation>el texto termina donde debe haber un valor</translation>
    </message>
    <message>
        <source>a value must stand here</source>
        <translation>aquí debe haber un valor</translation>
    </message>
    <message>
        <source>a digit must stand here</source>
        <translation>aquí debe haber una cifra</translation>
    </message>
    <message>
        <source>the text ends inside a string</source>
        <translation>el texto termina dentro de una cadena</translation>
    </message>
    <message>
        <source>a control character must be written as an escape</source>
        <translation>un carácter de control debe escribirse como secuencia de escape</translation>
    </message>
    <message>
        <source>unknown escape in a string</source>
        <translation>secuencia de escape desconocida en una cadena</translation>
    </message>
    <message>
        <source>half a surrogate pair in a string</source>
        <translation>medio par sustituto en una cadena</translation>
    </message>
    <message>
        <source>four hexadecimal digits must stand here</source>
        <translation>aquí debe haber cuatro cifras hexadecimales</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>demasiados niveles anidados</translation>
    </message>
    <message>
        <source>a comma or %1 must stand here</source>
        <translation>aquí debe haber una coma o %1</translation>
    </message>
    <message>
        <source>a key in quotes must stand here</source>
        <translation>aquí debe haber una clave entre comillas</translation>
    </message>
    <message>
        <source>a colon must stand here</source>
        <translation>aquí debe haber dos puntos</translation>
    </message>
    <message>
        <source>nothing more may stand here</source>
        <translation>aquí ya no puede haber nada</translation>
    </message>
</context>
<context>
    <name>ui::KeysPage</name>
    <message>
        <source>%1, previous</source>
        <translation>%1, ant.</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>En la escena</translation>
    </message>
    <message>
        <source>Wheel, drag</source>
        <translation>Rueda, arrastrar</translation>
    </message>
    <message>
        <source>Zoom, move the view</source>
        <translation>Zoom, mover la vista</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doble clic</translation>
    </message>
    <message>
        <source>Fit the room</source>
        <translation>Encuadrar la sala</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Select a weight</source>
        <translation>Seleccionar una pesa</translation>
    </message>
    <message>
        <source>Drag a weight</source>
        <translation>Arrastrar una pesa</translation>
    </message>
    <message>
        <source>Set its angle or place</source>
        <translation>Ángulo o posición</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Mayús+arrastrar</translation>
    </message>
    <message>
        <source>Set its rope&apos;s length</source>
        <translation>Longitud de la cuerda</translation>
    </message>
    <message>
        <source>Drag its arrow</source>
        <translation>Arrastrar su flecha</translation>
    </message>
    <message>
        <source>Set its velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+arrastrar</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Valores redondos</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+flechas</translation>
    </message>
    <message>
        <source>Move the weight</source>
        <translation>Mover la pesa</translation>
    </message>
    <message>
        <source>Alt+Shift+arrows</source>
        <translation>Alt+Mayús+flechas</translation>
    </message>
    <message>
        <source>Change its velocity</source>
        <translation>Cambiar su velocidad</translation>
    </message>
    <message>
        <source>In the table</source>
        <translation>En la tabla</translation>
    </message>
    <message>
        <source>Ins, Del</source>
        <translation>Insert, Supr</translation>
    </message>
    <message>
        <source>Add, remove weights</source>
        <translation>Añadir, quitar pesas</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+V</translation>
    </message>
    <message>
        <source>Copy, paste cells</source>
        <translation>Copiar, pegar celdas</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Rellenar hacia abajo</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>En un gráfico</translation>
    </message>
    <message>
        <source>Wheel, + −</source>
        <translation>Rueda, + −</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Arrastrar</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Ampliar un recuadro</translation>
    </message>
    <message>
        <source>Shift+drag, Alt+arrows</source>
        <translation>Mayús+arrastrar, Alt+flechas</translation>
    </message>
    <message>
        <source>Move what it shows</source>
        <translation>Mover el contenido</translation>
    </message>
    <message>
        <source>Double click, 0</source>
        <translation>Doble clic, 0</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>En todas partes</translation>
    </message>
    <message>
        <source>Return, Escape</source>
        <translation>Intro, Esc</translation>
    </message>
    <message>
        <source>Apply, restore a field</source>
        <translation>Aplicar, restaurar</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Mayús+Tab</translation>
    </message>
    <message>
        <source>Next, previous field</source>
        <translation>Campo siguiente, ant.</translation>
    </message>
    <message>
        <source>Alt+letter</source>
        <translation>Alt+letra</translation>
    </message>
    <message>
        <source>Open that menu</source>
        <translation>Abrir ese menú</translation>
    </message>
</context>
<context>
    <name>ui::LessonChooser</name>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Arrow keys and Enter, or a click, open a lesson.</source>
        <translation>Las flechas e Intro, o un clic, abren una lección.</translation>
    </message>
</context>
<context>
    <name>ui::LessonPanel</name>
    <message>
        <source>To try</source>
        <translation>Para probar</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Todas las lecciones</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Hoja</translation>
    </message>
</context>
<context>
    <name>ui::Lessons</name>
    <message>
        <source>One pendulum</source>
        <translation>Un péndulo</translation>
    </message>
    <message>
        <source>Watch one weight swing, lose its rope on the way up, fly and bounce: Euler swings higher than it started, RK4 does not.</source>
        <translation>Observe una pesa que oscila, pierde su cuerda al subir, vuela y rebota: Euler sube más alto que al inicio, RK4 no.</translation>
    </message>
    <message>
        <source>Press R, then cut the rope yourself with C: when must you cut for the longest throw?</source>
        <translation>Pulse R y corte usted mismo la cuerda con C: ¿cuándo hay que cortar para el lanzamiento más largo?</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller under Runs: about a tenth of its error is left.</source>
        <translation>Dé a Euler un paso diez veces menor en Simulaciones: queda cerca de la décima parte de su error.</translation>
    </message>
    <message>
        <source>Set the air density to 0: does the total still stay flat with both methods?</source>
        <translation>Ponga la densidad del aire a 0: ¿sigue siendo constante la energía total con ambos métodos?</translation>
    </message>
    <message>
        <source>Two weights</source>
        <translation>Dos pesas</translation>
    </message>
    <message>
        <source>Watch a small and a large weight of the same lead swing towards each other: when they meet in the air, the light one is thrown back.</source>
        <translation>Observe cómo una pesa pequeña y otra grande del mismo plomo oscilan una hacia la otra: cuando chocan en el aire, la ligera sale despedida hacia atrás.</translation>
    </message>
    <message>
        <source>Press I to go to the impact and read the speeds before and after under Events.</source>
        <translation>Pulse I para ir al choque y lea en Eventos las velocidades antes y después.</translation>
    </message>
    <message>
        <source>Give both weights the same mass: who is thrown back now?</source>
        <translation>Dé a ambas pesas la misma masa: ¿cuál sale despedida hacia atrás ahora?</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0: how much energy is lost to the impact?</source>
        <translation>Ponga la restitución de las pesas a 0: ¿cuánta energía se pierde en el choque?</translation>
    </message>
    <message>
        <source>Three pendulums</source>
        <translation>Tres péndulos</translation>
    </message>
    <message>
        <source>Watch three ropes of different length start together and fall out of step: the longer the rope, the slower the swing.</source>
        <translation>Observe tres cuerdas de distinta longitud que salen juntas y se desfasan: cuanto más larga es la cuerda, más lenta es la oscilación.</translation>
    </message>
    <message>
        <source>Make the first rope 0.3 m long: the third, four times as long, swings half as fast.</source>
        <translation>Dé 0,3 m a la primera cuerda: la tercera, cuatro veces más larga, oscila la mitad de rápido.</translation>
    </message>
    <message>
        <source>Change the mass of one weight: is its swing slower now?</source>
        <translation>Cambie la masa de una pesa: ¿oscila ahora más despacio?</translation>
    </message>
    <message>
        <source>Press U to go from one turning point to the next and read the times under Events.</source>
        <translation>Pulse U para ir de un punto de retorno al siguiente y lea los instantes en Eventos.</translation>
    </message>
    <message>
        <source>Seven weights in a room</source>
        <translation>Siete pesas en una sala</translation>
    </message>
    <message>
        <source>Watch seven weights swing, all ropes cut at once: they fly, bounce off each other, the walls and the floor, and two methods soon disagree about where.</source>
        <translation>Observe siete pesas que oscilan, con todas las cuerdas cortadas a la vez: vuelan, chocan entre sí, con las paredes y con el suelo, y pronto dos métodos discrepan sobre dónde están.</translation>
    </message>
    <message>
        <source>Press V to give each method a view of its own.</source>
        <translation>Pulse V para dar a cada método su propia vista.</translation>
    </message>
    <message>
        <source>Guess which weight comes to rest first, and look it up under Events.</source>
        <translation>Adivine qué pesa queda antes en reposo, y compruébelo en Eventos.</translation>
    </message>
    <message>
        <source>Halve the step of one method: how much later do the two part?</source>
        <translation>Reduzca a la mitad el paso de un método: ¿cuánto más tarde se separan los dos?</translation>
    </message>
    <message>
        <source>Euler gains energy</source>
        <translation>Euler gana energía</translation>
    </message>
    <message>
        <source>Watch Euler swing a pendulum higher and higher without a push, until it goes over the top: its energy comes from the method, not from physics.</source>
        <translation>Observe cómo Euler hace oscilar un péndulo cada vez más alto sin empujarlo, hasta dar la vuelta por arriba: esa energía viene del método, no de la física.</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller: it still gains energy, only more slowly.</source>
        <translation>Dé a Euler un paso diez veces menor: sigue ganando energía, solo que más despacio.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: all that is hatched was made by the method.</source>
        <translation>Abra el gráfico Balance: todo lo rayado lo creó el método.</translation>
    </message>
    <message>
        <source>Choose Euler (semi-implicit) for the second run and compare.</source>
        <translation>Elija Euler (semiimplícito) para la segunda simulación y compare.</translation>
    </message>
    <message>
        <source>Two kinds of Euler</source>
        <translation>Dos tipos de Euler</translation>
    </message>
    <message>
        <source>Watch two methods that differ in a single line, whether the new or the old speed moves the weight: one gains energy for ever, the other never strays far.</source>
        <translation>Observe dos métodos que difieren en una sola línea, si mueve la pesa la velocidad nueva o la antigua: uno gana energía sin fin, el otro nunca se desvía mucho.</translation>
    </message>
    <message>
        <source>Open the Phase chart: one draws a closed loop, the other a spiral.</source>
        <translation>Abra el gráfico Fase: uno dibuja una curva cerrada; el otro, una espiral.</translation>
    </message>
    <message>
        <source>Switch on Runge–Kutta 4 as a third run with the same step: what does its energy do?</source>
        <translation>Añada Runge–Kutta 4 como tercera simulación con el mismo paso: ¿qué hace su energía?</translation>
    </message>
    <message>
        <source>Let it play for a minute at speed 8×: is the first run still the same?</source>
        <translation>Déjelo correr un minuto a velocidad 8×: ¿sigue siendo igual la primera simulación?</translation>
    </message>
    <message>
        <source>Half the step</source>
        <translation>La mitad del paso</translation>
    </message>
    <message>
        <source>Watch the distance from the first run, which is exact: with half the step Euler errs half as much, and RK4 hardly at all.</source>
        <translation>Observe la distancia a la primera simulación, que es exacta: con la mitad del paso Euler yerra la mitad, y RK4 casi nada.</translation>
    </message>
    <message>
        <source>Open Comparison and read the distances after one second and after four.</source>
        <translation>Abra Comparación y lea las distancias tras un segundo y tras cuatro.</translation>
    </message>
    <message>
        <source>Halve the step of Runge–Kutta 4: its error shrinks to about a sixteenth.</source>
        <translation>Reduzca a la mitad el paso de Runge–Kutta 4: su error baja a cerca de un dieciseisavo.</translation>
    </message>
    <message>
        <source>Open Run ▸ Speed and accuracy to see the same for many steps at once.</source>
        <translation>Abra Simulación ▸ Velocidad y precisión para ver lo mismo con muchos pasos a la vez.</translation>
    </message>
    <message>
        <source>Step too large</source>
        <translation>Paso demasiado grande</translation>
    </message>
    <message>
        <source>Watch the air stop a balloon in three ways: slowly with a small step, dead with a larger one, and never with one that throws it back faster each time.</source>
        <translation>Observe cómo el aire frena un globo de tres maneras: despacio con un paso pequeño, en seco con uno mayor, y nunca con uno que lo devuelve cada vez más rápido.</translation>
    </message>
    <message>
        <source>Press R and then → again and again: see how each large step overshoots.</source>
        <translation>Pulse R y luego → una y otra vez: vea cómo cada paso grande se pasa de largo.</translation>
    </message>
    <message>
        <source>Open Inside a step for the third run: its one slope points far beyond the other side.</source>
        <translation>Abra Dentro de un paso para la tercera simulación: su única pendiente apunta mucho más allá del otro lado.</translation>
    </message>
    <message>
        <source>Look for the largest step of the third run that does not blow up.</source>
        <translation>Busque el mayor paso de la tercera simulación que no estalla.</translation>
    </message>
    <message>
        <source>Small and large swings</source>
        <translation>Oscilaciones pequeñas y grandes</translation>
    </message>
    <message>
        <source>Watch four pendulums of the same length start together: only small swings keep the same time, and the wider one swings, the longer it takes.</source>
        <translation>Observe cuatro péndulos de igual longitud que salen juntos: solo las oscilaciones pequeñas tienen el mismo periodo, y cuanto mayor es la amplitud, más tardan.</translation>
    </message>
    <message>
        <source>Press U to find the first turning points and compare the times.</source>
        <translation>Pulse U para hallar los primeros puntos de retorno y compare los instantes.</translation>
    </message>
    <message>
        <source>Set the start angles to 5°, 10°, 15° and 20°: now they keep step for a long time.</source>
        <translation>Ponga los ángulos iniciales a 5°, 10°, 15° y 20°: ahora siguen en fase mucho tiempo.</translation>
    </message>
    <message>
        <source>Set one start angle to 179.9°: how long does it stay near the top?</source>
        <translation>Ponga un ángulo inicial a 179,9°: ¿cuánto tiempo se queda cerca de lo más alto?</translation>
    </message>
    <message>
        <source>Slack rope</source>
        <translation>Cuerda destensada</translation>
    </message>
    <message>
        <source>Watch a rod and a rope with the same push: the rod carries its weight over the top, the rope goes slack on the way up and jerks tight on the way down.</source>
        <translation>Observe una varilla y una cuerda con el mismo impulso: la varilla lleva su pesa por encima de lo más alto, la cuerda se destensa al subir y da un tirón al bajar.</translation>
    </message>
    <message>
        <source>Switch to speed 1/8× at the moment the rope goes slack: the weight flies as if thrown.</source>
        <translation>Pase a velocidad 1/8× en el momento en que la cuerda se destensa: la pesa vuela como si la hubieran lanzado.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: how much energy does the jerk cost?</source>
        <translation>Abra el gráfico Balance: ¿cuánta energía cuesta el tirón?</translation>
    </message>
    <message>
        <source>Change gravity until the rope stays taut all the way round.</source>
        <translation>Cambie la gravedad hasta que la cuerda siga tensa en toda la vuelta.</translation>
    </message>
    <message>
        <source>A throw with and without air</source>
        <translation>Un lanzamiento con y sin aire</translation>
    </message>
    <message>
        <source>Watch two equal throws, one through air and one that the air does not touch: with air the path is shorter, lower and steeper at its end.</source>
        <translation>Observe dos lanzamientos iguales, uno a través del aire y otro que el aire no frena: con aire la trayectoria es más corta, más baja y más empinada al final.</translation>
    </message>
    <message>
        <source>Open the Paths chart: which of the two paths is a parabola?</source>
        <translation>Abra el gráfico Trayectorias: ¿cuál de las dos es una parábola?</translation>
    </message>
    <message>
        <source>Make the first ball ten times as heavy: how much further does it get?</source>
        <translation>Haga la primera bola diez veces más pesada: ¿cuánto más lejos llega?</translation>
    </message>
    <message>
        <source>Set the air density to 0: now both paths have the same shape.</source>
        <translation>Ponga la densidad del aire a 0: ahora ambas trayectorias tienen la misma forma.</translation>
    </message>
    <message>
        <source>Terminal velocity</source>
        <translation>Velocidad límite</translation>
    </message>
    <message>
        <source>Watch three balls of one size fall: the light ones soon fall at a constant speed, where the drag of the air is as large as their weight.</source>
        <translation>Observe la caída de tres bolas del mismo tamaño: las ligeras pronto caen a velocidad constante, a la que la resistencia del aire iguala su peso.</translation>
    </message>
    <message>
        <source>Open the Speed chart: whose curve becomes level, and how soon?</source>
        <translation>Abra el gráfico Velocidad: ¿qué curva se vuelve horizontal, y cuánto tarda?</translation>
    </message>
    <message>
        <source>Read off both level speeds: the second ball is four times as heavy as the first.</source>
        <translation>Lea las dos velocidades constantes: la segunda bola es cuatro veces más pesada que la primera.</translation>
    </message>
    <message>
        <source>Set the air density to 0: all three hit the floor together.</source>
        <translation>Ponga la densidad del aire a 0: las tres llegan juntas al suelo.</translation>
    </message>
    <message>
        <source>Infinitely many bounces</source>
        <translation>Infinitos rebotes</translation>
    </message>
    <message>
        <source>Watch a ball that loses a fifth of its speed at every bounce: it bounces infinitely often, and yet all bounces are over within six seconds.</source>
        <translation>Observe una bola que pierde un quinto de su velocidad en cada rebote: rebota infinitas veces, y aun así todos los rebotes acaban en menos de seis segundos.</translation>
    </message>
    <message>
        <source>Open the Height chart and zoom in on the end: it looks the same again and again.</source>
        <translation>Abra el gráfico Altura y amplíe el final: se ve igual una y otra vez.</translation>
    </message>
    <message>
        <source>Go to the last impacts with I: the times between them form a geometric series.</source>
        <translation>Vaya a los últimos choques con I: los tiempos entre ellos forman una progresión geométrica.</translation>
    </message>
    <message>
        <source>Set the restitution of walls to 0.9: the bounces now last about twice as long.</source>
        <translation>Ponga la restitución de las paredes a 0,9: ahora los rebotes duran cerca del doble.</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>Péndulo de Newton</translation>
    </message>
    <message>
        <source>Watch one weight knock against four that hang at rest: only the last one flies off, because energy and momentum must both be kept.</source>
        <translation>Observe cómo una pesa golpea a cuatro que cuelgan en reposo: solo la última sale despedida, pues deben conservarse la energía y la cantidad de movimiento.</translation>
    </message>
    <message>
        <source>Pull two weights aside: give weight 2 the start angle −40°, too. How many fly off?</source>
        <translation>Separe dos pesas: dé también a la pesa 2 el ángulo inicial −40°. ¿Cuántas salen despedidas?</translation>
    </message>
    <message>
        <source>Play the impacts at speed 1/64×: the push passes through four weights in no time.</source>
        <translation>Reproduzca los choques a velocidad 1/64×: el impulso atraviesa cuatro pesas al instante.</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0.5: after a while all swing together.</source>
        <translation>Ponga la restitución de las pesas a 0,5: al cabo de un rato todas oscilan juntas.</translation>
    </message>
    <message>
        <source>Counting π by impacts</source>
        <translation>Contar π con choques</translation>
    </message>
    <message>
        <source>Watch a disc a hundred times as heavy drive a light one against the wall: there are 31 impacts before they part, the first digits of π.</source>
        <translation>Observe cómo un disco cien veces más pesado empuja a otro ligero contra la pared: hay 31 choques antes de que se separen, las primeras cifras de π.</translation>
    </message>
    <message>
        <source>Open Events and choose Impacts: count them until the heavy disc hits the right wall.</source>
        <translation>Abra Eventos y elija Choques: cuéntelos hasta que el disco pesado choque con la pared derecha.</translation>
    </message>
    <message>
        <source>Make the heavy disc 1000 kg, 10⁴ times the light one: there are 314 impacts.</source>
        <translation>Dé 1000 kg al disco pesado, 10⁴ veces el ligero: hay 314 choques.</translation>
    </message>
    <message>
        <source>Give the run a step ten times as large: the number stays the same. Why?</source>
        <translation>Dé a la simulación un paso diez veces mayor: el número no cambia. ¿Por qué?</translation>
    </message>
    <message>
        <source>A thousand pendulums</source>
        <translation>Mil péndulos</translation>
    </message>
    <message>
        <source>Watch a thousand pendulums start as one straight line, each a hair longer than the next: the line bends, winds up and falls apart into dust.</source>
        <translation>Observe mil péndulos que salen en una sola línea recta, cada uno un pelo más largo que el anterior: la línea se dobla, se enrolla y se deshace en polvo.</translation>
    </message>
    <message>
        <source>Stop after 5 s and after 20 s: are weights that started side by side still neighbours?</source>
        <translation>Pare a los 5 s y a los 20 s: ¿siguen siendo vecinas las pesas que salieron juntas?</translation>
    </message>
    <message>
        <source>Set all start angles to 170°: does the line fall apart sooner?</source>
        <translation>Ponga todos los ángulos iniciales a 170°: ¿se deshace antes la línea?</translation>
    </message>
    <message>
        <source>Press C while they swing: a thousand weights fly off along a thousand paths.</source>
        <translation>Pulse C mientras oscilan: mil pesas salen volando por mil trayectorias.</translation>
    </message>
    <message>
        <source>A pile comes to rest</source>
        <translation>Un montón queda en reposo</translation>
    </message>
    <message>
        <source>Watch balls rain into a box and settle: every impact takes some energy, until all lie still and no ball overlaps another.</source>
        <translation>Observe cómo llueven bolas en una caja y se asientan: cada choque quita algo de energía, hasta que todas reposan y ninguna se solapa con otra.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: where has all the energy gone?</source>
        <translation>Abra el gráfico Balance: ¿adónde fue toda la energía?</translation>
    </message>
    <message>
        <source>Set both restitutions to 0.8: how much longer does it take until all lie still?</source>
        <translation>Ponga ambas restituciones a 0,8: ¿cuánto más tardan todas en quedar en reposo?</translation>
    </message>
    <message>
        <source>Make the room twice as wide: how high is the pile now?</source>
        <translation>Haga la sala el doble de ancha: ¿qué altura tiene ahora el montón?</translation>
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
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;reciente</translation>
    </message>
    <message>
        <source>&amp;Built-in scenes</source>
        <translation>Escenas &amp;incluidas</translation>
    </message>
    <message>
        <source>Export energy &amp;ledger</source>
        <translation>Exportar &amp;balance de energía</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edición</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Simulación</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Ir a</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Paneles</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>&amp;Pesa</translation>
    </message>
    <message>
        <source>&amp;Chart</source>
        <translation>&amp;Gráfico</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Panels</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>Which of the panels that share this place is shown</source>
        <translation>Cuál de los paneles que comparten este lugar se muestra</translation>
    </message>
</context>
<context>
    <name>ui::MeasurementTable</name>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Deriva</translation>
    </message>
    <message>
        <source>Time/s</source>
        <translation>Cálculo/s</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Pendientes</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Step, or tolerance of an adaptive method</source>
        <translation>Paso, o tolerancia de un método adaptativo</translation>
    </message>
    <message>
        <source>Largest distance of any weight from where it really is</source>
        <translation>Mayor distancia de una pesa a su posición real</translation>
    </message>
    <message>
        <source>Largest numerical drift of the energy</source>
        <translation>Mayor deriva numérica de la energía</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Tiempo de cálculo por segundo simulado</translation>
    </message>
    <message>
        <source>Slope evaluations</source>
        <translation>Evaluaciones de pendiente</translation>
    </message>
    <message>
        <source>Whether the run came to the end</source>
        <translation>Si la simulación llegó al final</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to open it as a run</source>
        <translation>Haga doble clic en una fila, o pulse Intro, para abrirla como simulación</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>correcto</translation>
    </message>
    <message>
        <source>diverged at %1 s</source>
        <translation>diverge a los %1 s</translation>
    </message>
</context>
<context>
    <name>ui::OpenAsRun</name>
    <message>
        <source>addition of a run</source>
        <translation>adición de una simulación</translation>
    </message>
</context>
<context>
    <name>ui::PanelTitle</name>
    <message>
        <source>Take the panel out of the window, or put it back</source>
        <translation>Sacar el panel de la ventana, o devolverlo</translation>
    </message>
    <message>
        <source>Close the panel; the view menu brings it back</source>
        <translation>Cerrar el panel; el menú Ver lo recupera</translation>
    </message>
</context>
<context>
    <name>ui::PlaybackBar</name>
    <message>
        <source>%1× real time</source>
        <translation>%1× tiempo real</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Speed (, and .)</source>
        <translation>Velocidad (, y .)</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Tiempo simulado</translation>
    </message>
    <message>
        <source>Whether the computer keeps up with the chosen speed</source>
        <translation>Si el ordenador sigue la velocidad elegida</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>in real time</source>
        <translation>en tiempo real</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Velocidad %1</translation>
    </message>
    <message>
        <source>Simulated seconds in a second of real time</source>
        <translation>Segundos simulados en un segundo real</translation>
    </message>
    <message>
        <source>Simulated time t, in s: the moment that all views show</source>
        <translation>Tiempo simulado t, en s: el instante que muestran todas las vistas</translation>
    </message>
</context>
<context>
    <name>ui::PresentationHeader</name>
    <message>
        <source>Simulated time</source>
        <translation>Tiempo simulado</translation>
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
        <translation>se esperaba al menos %1, no %2</translation>
    </message>
    <message>
        <source>must be from %1 to %2, got %3</source>
        <translation>se esperaba de %1 a %2, no %3</translation>
    </message>
    <message>
        <source>must be inside the room, got %1</source>
        <translation>debe estar dentro de la sala, no en %1</translation>
    </message>
    <message>
        <source>must put the whole weight, of radius %1 m, inside the room, got %2</source>
        <translation>debe dejar toda la pesa, de radio %1 m, dentro de la sala, no en %2</translation>
    </message>
    <message>
        <source>must not overlap %1 at the start</source>
        <translation>no debe solaparse con %1 al inicio</translation>
    </message>
    <message>
        <source>must be at most %1, got %2</source>
        <translation>se esperaba como máximo %1, no %2</translation>
    </message>
</context>
<context>
    <name>ui::ProblemWords</name>
    <message>
        <source>Gravity</source>
        <translation>La gravedad</translation>
    </message>
    <message>
        <source>The air density</source>
        <translation>La densidad del aire</translation>
    </message>
    <message>
        <source>The room&apos;s width</source>
        <translation>El ancho de la sala</translation>
    </message>
    <message>
        <source>The room&apos;s height</source>
        <translation>El alto de la sala</translation>
    </message>
    <message>
        <source>The room&apos;s restitution</source>
        <translation>La restitución de las paredes</translation>
    </message>
    <message>
        <source>The friction</source>
        <translation>El rozamiento</translation>
    </message>
    <message>
        <source>The weights&apos; restitution</source>
        <translation>La restitución de las pesas</translation>
    </message>
    <message>
        <source>The time of the cut</source>
        <translation>El instante del corte</translation>
    </message>
    <message>
        <source>The mass</source>
        <translation>La masa</translation>
    </message>
    <message>
        <source>The radius</source>
        <translation>El radio</translation>
    </message>
    <message>
        <source>The drag coefficient</source>
        <translation>El coeficiente de arrastre</translation>
    </message>
    <message>
        <source>The rope&apos;s length</source>
        <translation>La longitud de la cuerda</translation>
    </message>
    <message>
        <source>The start angle</source>
        <translation>El ángulo inicial</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>El paso</translation>
    </message>
    <message>
        <source>The rope of weight %1 is tied outside the room.</source>
        <translation>La cuerda de la pesa %1 está atada fuera de la sala.</translation>
    </message>
    <message>
        <source>Weight %1 does not start inside the room.</source>
        <translation>La pesa %1 no empieza dentro de la sala.</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 debe valer %2.</translation>
    </message>
    <message>
        <source>%1 (number %2) must be %3.</source>
        <translation>%1 (n.º %2) debe valer %3.</translation>
    </message>
    <message>
        <source>Weights %1 and %2 overlap at the start.</source>
        <translation>Las pesas %1 y %2 se solapan al inicio.</translation>
    </message>
    <message numerus="yes">
        <source>(and %n more problem(s))</source>
        <translation>
            <numerusform>(y %n problema más)</numerusform>
            <numerusform>(y %n problemas más)</numerusform>
        </translation>
    </message>
    <message>
        <source>The angular velocity</source>
        <translation>La velocidad angular</translation>
    </message>
    <message>
        <source>The velocity x</source>
        <translation>La velocidad x</translation>
    </message>
    <message>
        <source>The velocity y</source>
        <translation>La velocidad y</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>La tolerancia</translation>
    </message>
    <message>
        <source>There are more than %1 runs.</source>
        <translation>Hay más de %1 simulaciones.</translation>
    </message>
    <message>
        <source>There are more than %1 weights.</source>
        <translation>Hay más de %1 pesas.</translation>
    </message>
</context>
<context>
    <name>ui::QuantityField</name>
    <message>
        <source>Must be %1</source>
        <translation>Debe valer %1</translation>
    </message>
</context>
<context>
    <name>ui::QuantitySpinBox</name>
    <message>
        <source>several</source>
        <translation>varios</translation>
    </message>
</context>
<context>
    <name>ui::Range</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 o más</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
</context>
<context>
    <name>ui::RecentFiles</name>
    <message>
        <source>%1 (gone)</source>
        <translation>%1 (ya no está)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Borrar esta lista</translation>
    </message>
    <message>
        <source>The file is no longer there. It is taken off the list.</source>
        <translation>El archivo ya no está. Se quita de la lista.</translation>
    </message>
</context>
<context>
    <name>ui::Recovery</name>
    <message>
        <source>The program ended before changes of %1 were saved, on %2.</source>
        <translation>El programa terminó antes de guardar los cambios de %1, el %2.</translation>
    </message>
    <message>
        <source>a new scene</source>
        <translation>una escena nueva</translation>
    </message>
    <message>
        <source>recovery of changes</source>
        <translation>recuperación de cambios</translation>
    </message>
</context>
<context>
    <name>ui::RunWords</name>
    <message>
        <source>Euler (explicit)</source>
        <translation>Euler (explícito)</translation>
    </message>
    <message>
        <source>Euler (semi-implicit)</source>
        <translation>Euler (semiimplícito)</translation>
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
        <translation>Referencia</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, tolerancia %2</translation>
    </message>
    <message>
        <source>%1, %2 s</source>
        <translation>%1, %2 s</translation>
    </message>
    <message>
        <source>%1, diverged at %2 s. Its last finite state is shown; try a smaller step.</source>
        <translation>%1, diverge a los %2 s. Se muestra su último estado finito; pruebe un paso menor.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: one step held more impacts than a step may.</source>
        <translation>%1, parada a los %2 s: un paso contenía más choques de los que admite un paso.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: the tolerance asks for more or smaller steps than can be taken.</source>
        <translation>%1, parada a los %2 s: la tolerancia exige más pasos o más pequeños de lo posible.</translation>
    </message>
</context>
<context>
    <name>ui::RunsForm</name>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Step, tolerance</source>
        <translation>Paso, tolerancia</translation>
    </message>
    <message>
        <source>Step of run %1</source>
        <translation>Paso de la simulación %1</translation>
    </message>
    <message>
        <source>Tolerance of run %1</source>
        <translation>Tolerancia de la simulación %1</translation>
    </message>
    <message>
        <source>Method of run %1</source>
        <translation>Método de la simulación %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Simulación %1</translation>
    </message>
    <message>
        <source>addition of a run</source>
        <translation>adición de una simulación</translation>
    </message>
    <message>
        <source>removal of a run</source>
        <translation>eliminación de una simulación</translation>
    </message>
    <message>
        <source>change of the method</source>
        <translation>cambio del método</translation>
    </message>
    <message>
        <source>How the run gets from one moment to the next. The error of a method of order p shrinks with the step h like h to the power of p.</source>
        <translation>Cómo pasa la simulación de un instante al siguiente. El error de un método de orden p disminuye con el paso h como h elevado a p.</translation>
    </message>
    <message>
        <source>Step h in s: how much simulated time the method takes at once. Smaller steps are more exact and cost more.</source>
        <translation>Paso h en s: cuánto tiempo simulado avanza el método de una vez. Un paso menor es más exacto y cuesta más.</translation>
    </message>
    <message>
        <source>Tolerance, without unit: the error the method allows itself in a step, in m, m/s, rad and rad/s. It chooses its steps accordingly.</source>
        <translation>Tolerancia, sin unidad: el error que el método se permite en un paso, en m, m/s, rad y rad/s. Elige sus pasos en consecuencia.</translation>
    </message>
    <message>
        <source>Compute the scene with this method, too</source>
        <translation>Calcular la escena también con este método</translation>
    </message>
</context>
<context>
    <name>ui::SceneAnnouncer</name>
    <message>
        <source>No weight selected</source>
        <translation>Ninguna pesa seleccionada</translation>
    </message>
    <message>
        <source>Weight %1 selected</source>
        <translation>Pesa %1 seleccionada</translation>
    </message>
    <message>
        <source>%1: weight %2, at %3 s</source>
        <comment>an event, such as: Impact on the floor</comment>
        <translation>%1: pesa %2, a los %3 s</translation>
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
        <translation>Las pesas solo se mueven al inicio: pulse Inicio, o R para reiniciar</translation>
    </message>
</context>
<context>
    <name>ui::SceneDrop</name>
    <message>
        <source>What was dropped</source>
        <translation>Lo que se soltó</translation>
    </message>
    <message>
        <source>These are %1 files. Drop one scene file.</source>
        <translation>Son %1 archivos. Suelte un solo archivo de escena.</translation>
    </message>
    <message>
        <source>It is no file on this computer.</source>
        <translation>No es un archivo de este ordenador.</translation>
    </message>
    <message>
        <source>It is a folder. Drop a scene file.</source>
        <translation>Es una carpeta. Suelte un archivo de escena.</translation>
    </message>
</context>
<context>
    <name>ui::SceneFile</name>
    <message>
        <source>not UTF-8</source>
        <translation>no es UTF-8</translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>no es JSON: %1</translation>
    </message>
    <message>
        <source>larger than 64 MiB</source>
        <translation>más de 64 MiB</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>not UTF-8 but UTF-16; save it as UTF-8</source>
        <translation>no es UTF-8 sino UTF-16; guárdelo como UTF-8</translation>
    </message>
    <message>
        <source>it is no file but a pipe or a device</source>
        <translation>no es un archivo sino una tubería o un dispositivo</translation>
    </message>
</context>
<context>
    <name>ui::SceneFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>The scene has changes that are not saved. Save them?</source>
        <translation>La escena tiene cambios sin guardar. ¿Guardarlos?</translation>
    </message>
    <message>
        <source>What could not be applied is not saved: %1</source>
        <translation>No se guarda lo que no pudo aplicarse: %1</translation>
    </message>
    <message>
        <source>start of a new scene</source>
        <translation>inicio de una escena nueva</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Abrir escena</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Escenas (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Scene not opened</source>
        <translation>Escena no abierta</translation>
    </message>
    <message>
        <source>%1 was not opened:
%2</source>
        <translation>No se abrió %1:
%2</translation>
    </message>
    <message>
        <source>opening of %1</source>
        <translation>apertura de %1</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Guardar escena</translation>
    </message>
    <message>
        <source>Scene (*%1 *.json)</source>
        <translation>Escena (*%1 *.json)</translation>
    </message>
    <message>
        <source>Scene not saved</source>
        <translation>Escena no guardada</translation>
    </message>
    <message>
        <source>%1 was not saved:
%2</source>
        <translation>No se guardó %1:
%2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 guardado</translation>
    </message>
</context>
<context>
    <name>ui::SceneForm</name>
    <message>
        <source>Cut at</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesas</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Air density</source>
        <translation>Densidad del aire</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Sala</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Choques</translation>
    </message>
    <message>
        <source>Restitution of walls</source>
        <translation>Restitución de paredes</translation>
    </message>
    <message>
        <source>Friction of walls</source>
        <translation>Rozamiento de paredes</translation>
    </message>
    <message>
        <source>Restitution of weights</source>
        <translation>Restitución de pesas</translation>
    </message>
    <message>
        <source>Unticked: all ropes are cut by hand, with the Cut button</source>
        <translation>Sin marcar: todas las cuerdas se cortan a mano, con el botón Cortar</translation>
    </message>
    <message>
        <source>Time of the cut</source>
        <translation>Instante del corte</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>cambio del corte</translation>
    </message>
    <message>
        <source>How many weights there are, hung up at even intervals. New ones are like the last one.</source>
        <translation>Cuántas pesas hay, colgadas a intervalos iguales. Las nuevas son como la última.</translation>
    </message>
    <message>
        <source>Acceleration of free fall g, in m/s². It pulls each weight down with the force m g. On Earth 9.81 m/s².</source>
        <translation>Aceleración de la caída libre g, en m/s². Tira de cada pesa hacia abajo con la fuerza m g. En la Tierra 9,81 m/s².</translation>
    </message>
    <message>
        <source>Density of the air ρ, in kg/m³. Drag is F = ½ ρ c_d A v² against the velocity, with A = π r². 1.2 kg/m³ at sea level, 0 for vacuum.</source>
        <translation>Densidad del aire ρ, en kg/m³. La resistencia es F = ½ ρ c_d A v², opuesta a la velocidad, con A = π r². 1,2 kg/m³ al nivel del mar, 0 en el vacío.</translation>
    </message>
    <message>
        <source>Distance between the walls, in m.</source>
        <translation>Distancia entre las paredes, en m.</translation>
    </message>
    <message>
        <source>Distance between floor and ceiling, in m.</source>
        <translation>Distancia entre el suelo y el techo, en m.</translation>
    </message>
    <message>
        <source>Share e of the speed towards a wall, the floor or the ceiling with which a weight leaves it: 1 loses nothing, 0 does not bounce.</source>
        <translation>Parte e de la velocidad hacia una pared, el suelo o el techo con la que una pesa sale de ellos: 1 no pierde nada, 0 no rebota.</translation>
    </message>
    <message>
        <source>Friction coefficient μ of walls, floor and ceiling. Friction is at most μ times the force, or the impulse, that presses the weight against them.</source>
        <translation>Coeficiente de rozamiento μ de las paredes, el suelo y el techo. El rozamiento vale como máximo μ veces la fuerza, o el impulso, que aprieta la pesa contra ellos.</translation>
    </message>
    <message>
        <source>Share e of the speed towards each other with which two weights part after an impact: 1 loses nothing, 0 does not bounce.</source>
        <translation>Parte e de la velocidad de acercamiento con la que dos pesas se separan tras un choque: 1 no pierde nada, 0 no rebota.</translation>
    </message>
    <message>
        <source>Simulated time in s at which all ropes are cut.</source>
        <translation>Tiempo simulado en s en el que se cortan todas las cuerdas.</translation>
    </message>
</context>
<context>
    <name>ui::SceneLoading</name>
    <message>
        <source>Opening %1…</source>
        <translation>Abriendo %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>ui::SceneMarker</name>
    <message>
        <source>Weight %1</source>
        <translation>Pesa %1</translation>
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
        <translation>Escena</translation>
    </message>
    <message>
        <source>a picture&apos;s name must end in .png, .svg or .pdf</source>
        <translation>el nombre de una imagen debe terminar en .png, .svg o .pdf</translation>
    </message>
</context>
<context>
    <name>ui::SceneReader</name>
    <message>
        <source>is missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>se esperaba %1, no %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads version %2</source>
        <translation>%1 es más reciente que este programa, que lee la versión %2</translation>
    </message>
    <message>
        <source>must have either rope or position, got both</source>
        <translation>debe tener o rope o position, no ambos</translation>
    </message>
    <message>
        <source>must have either rope or position, got neither</source>
        <translation>debe tener o rope o position, y faltan ambos</translation>
    </message>
    <message>
        <source>velocity goes with position, got it with rope</source>
        <translation>velocity va con position, no con rope</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 usa una tolerancia, no un paso</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 usa un paso, no una tolerancia</translation>
    </message>
    <message>
        <source>must be like &quot;#e69f00&quot;, got %1</source>
        <translation>debe ser como &quot;#e69f00&quot;, no %1</translation>
    </message>
    <message>
        <source>there is no method named %1</source>
        <translation>no hay ningún método llamado %1</translation>
    </message>
</context>
<context>
    <name>ui::SceneToolbar</name>
    <message>
        <source>Scene tools</source>
        <translation>Herramientas de la escena</translation>
    </message>
</context>
<context>
    <name>ui::SceneView</name>
    <message>
        <source>at the selected weight only</source>
        <translation>solo para la pesa seleccionada</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>peso</translation>
    </message>
    <message>
        <source>air</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>cuerda</translation>
    </message>
    <message>
        <source>weights enlarged</source>
        <translation>pesas ampliadas</translation>
    </message>
    <message>
        <source>Δx %1, Δy %2</source>
        <translation>Δx %1, Δy %2</translation>
    </message>
    <message>
        <source>Trails shortened: many weights</source>
        <translation>Estelas acortadas: muchas pesas</translation>
    </message>
    <message>
        <source>No trails: too many weights</source>
        <translation>Sin estelas: demasiadas pesas</translation>
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
        <translation>QPainter (se perdió OpenGL)</translation>
    </message>
    <message>
        <source>QPainter (no OpenGL 3.3)</source>
        <translation>QPainter (sin OpenGL 3.3)</translation>
    </message>
    <message>
        <source>QPainter (software OpenGL would be slower)</source>
        <translation>QPainter (OpenGL por software sería más lento)</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>step × %1</source>
        <translation>paso × %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stopwatch runs</source>
        <translation>cronómetro en marcha</translation>
    </message>
    <message>
        <source>stopwatch stands</source>
        <translation>cronómetro parado</translation>
    </message>
    <message>
        <source>Hit at %1 s</source>
        <translation>Acierto a los %1 s</translation>
    </message>
    <message>
        <source>Missed by %1 m at %2 s</source>
        <translation>Fallo por %1 m a los %2 s</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Diana</translation>
    </message>
    <message>
        <source>The room with its weights and ropes. A click selects a weight, the wheel zooms, dragging moves the view.</source>
        <translation>La sala con sus pesas y cuerdas. Un clic selecciona una pesa, la rueda amplía, arrastrar mueve la vista.</translation>
    </message>
</context>
<context>
    <name>ui::SeparationChart</name>
    <message>
        <source>Distance between the runs over time</source>
        <translation>Distancia entre las simulaciones a lo largo del tiempo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, in m, on a logarithmic axis</source>
        <translation>Mayor distancia entre la misma pesa de ambas simulaciones, en m, en un eje logarítmico</translation>
    </message>
</context>
<context>
    <name>ui::Settings</name>
    <message>
        <source>The settings in %1 were damaged; what could not be read is as at first.</source>
        <translation>Los ajustes de %1 estaban dañados; lo que no se pudo leer está como al principio.</translation>
    </message>
    <message>
        <source>Settings are not remembered: nothing can be written to %1</source>
        <translation>Los ajustes no se recuerdan: no se puede escribir en %1</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPanel</name>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Stability map</source>
        <translation>Mapa de estabilidad</translation>
    </message>
    <message>
        <source>Method of the map</source>
        <translation>Método del mapa</translation>
    </message>
    <message>
        <source>What the map changes besides the step</source>
        <translation>Lo que varía el mapa además del paso</translation>
    </message>
    <message>
        <source>Simulated time of each run</source>
        <translation>Tiempo simulado de cada simulación</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Step ×</source>
        <translation>Paso ×</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Tiempo simulado</translation>
    </message>
    <message>
        <source>rope length</source>
        <translation>longitud de la cuerda</translation>
    </message>
    <message>
        <source>air density</source>
        <translation>densidad del aire</translation>
    </message>
    <message>
        <source>Finds the largest step at which each method stays bounded, that is, makes less energy out of nothing than the scene has to move with.</source>
        <translation>Busca el mayor paso con el que cada método se mantiene acotado, es decir, crea de la nada menos energía de la que la escena tiene para moverse.</translation>
    </message>
    <message>
        <source>stability</source>
        <translation>estabilidad</translation>
    </message>
    <message>
        <source>Export stability map</source>
        <translation>Exportar mapa de estabilidad</translation>
    </message>
    <message>
        <source>For which steps the run keeps its energy, and for which it grows beyond all bounds</source>
        <translation>Para qué pasos la simulación conserva su energía, y para cuáles crece sin límite</translation>
    </message>
    <message>
        <source>How long each run is followed, in s: what grows slowly needs time to show</source>
        <translation>Cuánto se sigue cada simulación, en s: lo que crece despacio necesita tiempo para verse</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>Guardar el mapa como imagen</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPlot</name>
    <message>
        <source>drift under 1 %</source>
        <translation>deriva menor del 1 %</translation>
    </message>
    <message>
        <source>under 10 %</source>
        <translation>menor del 10 %</translation>
    </message>
    <message>
        <source>up to 100 %</source>
        <translation>hasta el 100 %</translation>
    </message>
    <message>
        <source>energy more than doubled</source>
        <translation>energía más que duplicada</translation>
    </message>
    <message>
        <source>diverged</source>
        <translation>diverge</translation>
    </message>
    <message>
        <source>%1, each run over %2 s. Drift as a share of the energy the scene has to move with; empty: the weights do not fit the room.</source>
        <translation>%1, cada simulación durante %2 s. Deriva como parte de la energía disponible; vacío: las pesas no caben en la sala.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Length of the longest rope</source>
        <translation>Longitud de la cuerda más larga</translation>
    </message>
    <message>
        <source>Air density (kg/m³)</source>
        <translation>Densidad del aire (kg/m³)</translation>
    </message>
</context>
<context>
    <name>ui::StepPanel</name>
    <message>
        <source>of weight</source>
        <translation>de la pesa</translation>
    </message>
    <message>
        <source>Weight whose step is shown</source>
        <translation>Pesa cuyo paso se muestra</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Qué pesa, contada desde la izquierda</translation>
    </message>
    <message>
        <source>Run whose step is shown</source>
        <translation>Simulación cuyo paso se muestra</translation>
    </message>
    <message>
        <source>Part of the step</source>
        <translation>Parte del paso</translation>
    </message>
    <message>
        <source>Events divide a step: the method starts anew after each</source>
        <translation>Los eventos dividen un paso: el método empieza de nuevo tras cada uno</translation>
    </message>
    <message>
        <source>The coming step takes long to compute: go on to see it.</source>
        <translation>El paso siguiente tarda en calcularse: avance para verlo.</translation>
    </message>
    <message>
        <source>Part %1 of %2</source>
        <translation>Parte %1 de %2</translation>
    </message>
    <message>
        <source>There is no step to show.</source>
        <translation>No hay ningún paso que mostrar.</translation>
    </message>
    <message>
        <source>The reference takes no slopes: choose another run.</source>
        <translation>La referencia no evalúa pendientes: elija otra simulación.</translation>
    </message>
    <message>
        <source>Nothing moves the weight in this step.</source>
        <translation>Nada mueve la pesa en este paso.</translation>
    </message>
    <message>
        <source>to come, from %1 s to %2 s</source>
        <translation>siguiente, de %1 s a %2 s</translation>
    </message>
    <message>
        <source>from %1 s to %2 s</source>
        <translation>de %1 s a %2 s</translation>
    </message>
</context>
<context>
    <name>ui::StepPlot</name>
    <message>
        <source>The step against time</source>
        <translation>El paso según el tiempo</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exacto</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>The exact way, the slopes that the method took, and its end</source>
        <translation>El camino exacto, las pendientes que tomó el método y su final</translation>
    </message>
</context>
<context>
    <name>ui::StepTable</name>
    <message>
        <source>The step in numbers</source>
        <translation>El paso en cifras</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Mean slope</source>
        <translation>Pendiente media</translation>
    </message>
    <message>
        <source>End, %1</source>
        <translation>Final, %1</translation>
    </message>
    <message>
        <source>End, exact</source>
        <translation>Final, exacto</translation>
    </message>
    <message>
        <source>By a Taylor series from the same start</source>
        <translation>Por una serie de Taylor desde el mismo inicio</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>%1 in %2
slope in %3</source>
        <translation>%1 en %2
pendiente en %3</translation>
    </message>
    <message>
        <source>Error
in m</source>
        <translation>Error
en m</translation>
    </message>
    <message>
        <source>The slopes that the method took on its way, and where other methods end</source>
        <translation>Las pendientes que tomó el método en su camino, y dónde terminan otros métodos</translation>
    </message>
    <message>
        <source>Share of the slope in the mean that the step is taken with</source>
        <translation>Parte de la pendiente en la media con la que se da el paso</translation>
    </message>
    <message>
        <source>%1 at the start and the end, and as a slope how fast it changes</source>
        <translation>%1 al principio y al final, y como pendiente lo rápido que cambia</translation>
    </message>
    <message>
        <source>Distance of the end from the exact one, in m: the error of this step alone</source>
        <translation>Distancia del final al exacto, en m: el error de este único paso</translation>
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
        <translation>true o false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>se esperaba %1, no %2</translation>
    </message>
    <message>
        <source>%1 is too large or too small to reckon with</source>
        <translation>%1 es demasiado grande o pequeño para los cálculos</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>clave desconocida %1</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>aparece dos veces</translation>
    </message>
    <message>
        <source>must have %1 entries, got %2</source>
        <translation>se esperaban %1 elementos, no %2</translation>
    </message>
    <message>
        <source>must have %1 to %2 entries, got %3</source>
        <translation>se esperaban de %1 a %2 elementos, no %3</translation>
    </message>
</context>
<context>
    <name>ui::TaskRow</name>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Compute in the background; the same button stops it</source>
        <translation>Calcular en segundo plano; el mismo botón lo detiene</translation>
    </message>
</context>
<context>
    <name>ui::TimeCommands</name>
    <message>
        <source>Go to a time</source>
        <translation>Ir a un instante</translation>
    </message>
    <message>
        <source>Simulated time in s</source>
        <translation>Tiempo simulado en s</translation>
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
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>events from %1</source>
        <translation>eventos desde %1</translation>
    </message>
    <message>
        <source>%1 s: %2, weight: %3</source>
        <translation>%1 s: %2, pesa: %3</translation>
    </message>
    <message>
        <source>The recording from its start to its end, with marks for events. A click or dragging shows another moment; Home, End and the arrow keys do, too.</source>
        <translation>La grabación de principio a fin, con marcas para los eventos. Un clic o arrastrar muestra otro instante; Inicio, Fin y las flechas también.</translation>
    </message>
</context>
<context>
    <name>ui::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>La escena</translation>
    </message>
    <message>
        <source>Weights on ropes. Filled ones follow the first method, rings the others. At the start drag a weight to turn its rope; the wheel zooms.</source>
        <translation>Pesas colgadas de cuerdas. Las llenas siguen el primer método; los anillos, los demás. Al inicio arrastre una pesa para girar su cuerda; la rueda hace zoom.</translation>
    </message>
    <message>
        <source>Play and cut</source>
        <translation>Reproducir y cortar</translation>
    </message>
    <message>
        <source>Space plays and stops. C cuts all ropes, R goes back to the start. Slow motion makes an impact last for seconds.</source>
        <translation>Espacio reproduce y para. C corta todas las cuerdas, R vuelve al inicio. La cámara lenta hace que un choque dure segundos.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Paso a paso</translation>
    </message>
    <message>
        <source>The arrow keys → and ← go by one step, I goes to the next impact. Drag on this line to see any moment again.</source>
        <translation>Las flechas → y ← avanzan y retroceden un paso, I va al siguiente choque. Arrastre por esta línea para volver a ver cualquier instante.</translation>
    </message>
    <message>
        <source>Where the energy goes</source>
        <translation>Adónde va la energía</translation>
    </message>
    <message>
        <source>The total should be a flat line. What it climbs or falls was made or lost by the method, not by nature.</source>
        <translation>La energía total debería ser una línea plana. Lo que sube o baja lo creó o lo perdió el método, no la naturaleza.</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Métodos en paralelo</translation>
    </message>
    <message>
        <source>Up to four methods compute the same scene. Choose them and their steps here, and see who is right. Lessons, at the top right, has scenes to begin with.</source>
        <translation>Hasta cuatro métodos calculan la misma escena. Elíjalos aquí con sus pasos, y vea cuál acierta. En Lecciones, arriba a la derecha, hay escenas para empezar.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>End the tour; the Help menu has it again</source>
        <translation>Terminar el recorrido; el menú Ayuda lo ofrece de nuevo</translation>
    </message>
    <message>
        <source>Show the hint before</source>
        <translation>Mostrar la indicación anterior</translation>
    </message>
    <message>
        <source>Go on with the tour, or end it</source>
        <translation>Seguir con el recorrido, o terminarlo</translation>
    </message>
</context>
<context>
    <name>ui::TradeWindow</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Velocidad y precisión</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Estabilidad</translation>
    </message>
    <message>
        <source>%1 is run %2 now.</source>
        <translation>%1 es ahora la simulación %2.</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Qué se mide</translation>
    </message>
    <message>
        <source>What accuracy costs, or how large steps may be</source>
        <translation>Cuánto cuesta la precisión, o qué tamaño pueden tener los pasos</translation>
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
        <translation>%1 queda lejos con todos los ajustes medidos</translation>
    </message>
    <message>
        <source>%1 needs no more than %2</source>
        <translation>%1 necesita como mucho %2</translation>
    </message>
    <message>
        <source>%1 would need %2 (extrapolated along its order)</source>
        <translation>%1 necesitaría %2 (extrapolado según su orden)</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 necesita %2</translation>
    </message>
    <message>
        <source>Measured over %1 s.</source>
        <translation>Medido durante %1 s.</translation>
    </message>
    <message>
        <source>Measured over the first %1 s of %2 s: later not even the reference solution knows to 10⁻⁶ m where the weights are.</source>
        <translation>Medido durante los primeros %1 s de %2 s: después, ni la solución de referencia sabe con 10⁻⁶ m dónde están las pesas.</translation>
    </message>
    <message>
        <source>%1: no order seen</source>
        <translation>%1: no se aprecia ningún orden</translation>
    </message>
    <message>
        <source>%1: order %2</source>
        <translation>%1: orden %2</translation>
    </message>
    <message>
        <source>a tolerance of %1 and %2 of computing</source>
        <translation>una tolerancia de %1 y %2 de cálculo</translation>
    </message>
    <message>
        <source>a step of %1 and %2 of computing</source>
        <translation>un paso de %1 y %2 de cálculo</translation>
    </message>
    <message>
        <source>%1: none that was tried</source>
        <translation>%1: ninguno de los probados</translation>
    </message>
    <message>
        <source>%1: any</source>
        <translation>%1: cualquiera</translation>
    </message>
    <message>
        <source>%1: %2 s</source>
        <translation>%1: %2 s</translation>
    </message>
    <message>
        <source>Largest step that stays bounded over %1 s, that is, makes less energy out of nothing than the scene has to move with. %2.</source>
        <translation>Mayor paso que se mantiene acotado durante %1 s, es decir, que crea de la nada menos energía de la que la escena tiene para moverse. %2.</translation>
    </message>
    <message>
        <source>No time was simulated.</source>
        <translation>No se simuló ningún tiempo.</translation>
    </message>
    <message>
        <source>To be right within %1 over %2 s: %3.</source>
        <translation>Para un error de %1 como máximo durante %2 s: %3.</translation>
    </message>
</context>
<context>
    <name>ui::TravelBar</name>
    <message>
        <source>How far the computing has come</source>
        <translation>Hasta dónde ha llegado el cálculo</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Detener (Esc)</translation>
    </message>
    <message>
        <source>Computing: %1 s</source>
        <translation>Calculando: %1 s</translation>
    </message>
    <message>
        <source>Computing one step for %1 s</source>
        <translation>Calculando un solo paso desde hace %1 s</translation>
    </message>
</context>
<context>
    <name>ui::UndoCommands</name>
    <message>
        <source>Undone</source>
        <translation>Deshecho</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Deshecho: %1</translation>
    </message>
    <message>
        <source>Done again</source>
        <translation>Rehecho</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Rehecho: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightChart</name>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
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
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>The first %1 of %2 weights</source>
        <translation>Las primeras %1 de %2 pesas</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Weight %1</source>
        <translation>Pesa %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightColumns</name>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Coef. arrastre</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Hangs on</source>
        <translation>Cuelga de</translation>
    </message>
    <message>
        <source>Pivot x</source>
        <translation>Pivote x</translation>
    </message>
    <message>
        <source>Pivot y</source>
        <translation>Pivote y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Ángulo inicial</translation>
    </message>
    <message>
        <source>Angular velocity</source>
        <translation>Velocidad angular</translation>
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
        <translation>Velocidad x</translation>
    </message>
    <message>
        <source>Velocity y</source>
        <translation>Velocidad y</translation>
    </message>
    <message>
        <source>must be %1, got “%2”</source>
        <translation>se esperaba %1, no «%2»</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>like #e69f00, or automatic</source>
        <translation>algo como #e69f00, o automático</translation>
    </message>
    <message>
        <source>%1, %2 or %3</source>
        <translation>%1, %2 o %3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>cuerda</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>varilla</translation>
    </message>
    <message>
        <source>Color of the weight, such as #e69f00, or automatic</source>
        <translation>Color de la pesa, por ejemplo #e69f00, o automático</translation>
    </message>
    <message>
        <source>What holds the weight at the start: a rope, a rod, or nothing</source>
        <translation>Qué sostiene la pesa al inicio: una cuerda, una varilla o nada</translation>
    </message>
    <message>
        <source>Where the rope is tied: x from the left wall, y from the floor, in m</source>
        <translation>Dónde está atada la cuerda: x desde la pared izquierda, y desde el suelo, en m</translation>
    </message>
    <message>
        <source>Angular velocity ω at the start, in °/s, positive counterclockwise</source>
        <translation>Velocidad angular ω al inicio, en °/s, positiva en sentido antihorario</translation>
    </message>
    <message>
        <source>Center of the weight at the start: x from the left wall, y from the floor, in m</source>
        <translation>Centro de la pesa al inicio: x desde la pared izquierda, y desde el suelo, en m</translation>
    </message>
    <message>
        <source>Velocity v at the start: x to the right, y up, in m/s</source>
        <translation>Velocidad v al inicio: x a la derecha, y hacia arriba, en m/s</translation>
    </message>
    <message>
        <source>Mass m, in kg. It does not matter for a swing without air; with air a heavier weight is slowed down less.</source>
        <translation>Masa m, en kg. No importa en una oscilación sin aire; con aire, una pesa más pesada se frena menos.</translation>
    </message>
    <message>
        <source>Radius r, in m. Air meets the area A = π r².</source>
        <translation>Radio r, en m. El aire encuentra el área A = π r².</translation>
    </message>
    <message>
        <source>Drag coefficient c_d, without unit: how well the shape is held up by air. 0.47 for a sphere.</source>
        <translation>Coeficiente de arrastre c_d, sin unidad: cuánto frena el aire a la forma. 0,47 para una esfera.</translation>
    </message>
    <message>
        <source>Length of the rope L, in m: from its pivot to the center of the weight. A small swing takes T = 2π √(L/g).</source>
        <translation>Longitud de la cuerda L, en m: de su pivote al centro de la pesa. Una oscilación pequeña dura T = 2π √(L/g).</translation>
    </message>
    <message>
        <source>Angle θ of the rope at the start, in degrees from straight down, positive to the right.</source>
        <translation>Ángulo θ de la cuerda al inicio, en grados desde la vertical hacia abajo, positivo hacia la derecha.</translation>
    </message>
</context>
<context>
    <name>ui::WeightDrag</name>
    <message>
        <source>Angle %1°</source>
        <translation>Ángulo %1°</translation>
    </message>
    <message>
        <source>Length %1 m</source>
        <translation>Longitud %1 m</translation>
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
        <translation>cambio de velocidad</translation>
    </message>
    <message>
        <source>move of a weight</source>
        <translation>movimiento de una pesa</translation>
    </message>
    <message>
        <source>overlaps another weight</source>
        <translation>se solapa con otra pesa</translation>
    </message>
    <message>
        <source>outside the room</source>
        <translation>fuera de la sala</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>no es posible</translation>
    </message>
</context>
<context>
    <name>ui::WeightsClipboard</name>
    <message>
        <source>Weight %1, %2: %3</source>
        <translation>Pesa %1, %2: %3</translation>
    </message>
    <message>
        <source>a weight on a rope has none, got “%1”</source>
        <translation>no corresponde a una pesa con cuerda; se lee «%1»</translation>
    </message>
    <message>
        <source>a weight that hangs on nothing has none, got “%1”</source>
        <translation>no corresponde a una pesa que no cuelga de nada; se lee «%1»</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>está vacío</translation>
    </message>
    <message>
        <source>Line %1 has another number of columns than the first (%2, not %3).</source>
        <translation>La línea %1 tiene otro número de columnas que la primera (%2, no %3).</translation>
    </message>
    <message>
        <source>There are too many columns: %1, and from %2 on the table has %3.</source>
        <translation>Hay demasiadas columnas: %1, y a partir de %2 la tabla tiene %3.</translation>
    </message>
    <message>
        <source>There would be more than %1 weights.</source>
        <translation>Habría más de %1 pesas.</translation>
    </message>
    <message>
        <source>The clipboard holds no text.</source>
        <translation>El portapapeles no contiene texto.</translation>
    </message>
    <message>
        <source>There are only headings.</source>
        <translation>Solo hay encabezados.</translation>
    </message>
</context>
<context>
    <name>ui::WeightsForm</name>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Pesa</translation>
    </message>
    <message>
        <source>Which weight the fields below belong to, counted from the left</source>
        <translation>A qué pesa corresponden los campos de abajo, contada desde la izquierda</translation>
    </message>
    <message>
        <source>Rope</source>
        <translation>Cuerda</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Ángulo inicial</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Coeficiente de arrastre</translation>
    </message>
    <message>
        <source>All weights in a table…</source>
        <translation>Todas las pesas en una tabla…</translation>
    </message>
    <message>
        <source>Change many weights at once, and copy them from and to spreadsheets</source>
        <translation>Cambiar muchas pesas a la vez, y copiarlas de y a hojas de cálculo</translation>
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
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Tabla de pesas</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Add a weight</source>
        <translation>Añadir una pesa</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Add a copy of each selected weight</source>
        <translation>Añadir una copia de cada pesa seleccionada</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the selected weights</source>
        <translation>Quitar las pesas seleccionadas</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the selected cells for a spreadsheet</source>
        <translation>Copiar las celdas seleccionadas para una hoja de cálculo</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Paste cells, from a spreadsheet too, over those from the first selected one on</source>
        <translation>Pegar celdas, también de una hoja de cálculo, sobre las que siguen a la primera seleccionada</translation>
    </message>
    <message>
        <source>Paste as new</source>
        <translation>Pegar como nuevas</translation>
    </message>
    <message>
        <source>Add what was copied as new weights</source>
        <translation>Añadir lo copiado como pesas nuevas</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Rellenar abajo</translation>
    </message>
    <message>
        <source>Give all selected rows what the first of them holds</source>
        <translation>Dar a todas las filas seleccionadas lo que contiene la primera</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>cambio de %1</translation>
    </message>
    <message>
        <source>Nothing was changed. %1</source>
        <translation>No se cambió nada. %1</translation>
    </message>
    <message>
        <source>addition of a weight</source>
        <translation>adición de una pesa</translation>
    </message>
    <message>
        <source>duplication of weights</source>
        <translation>duplicación de pesas</translation>
    </message>
    <message>
        <source>removal of weights</source>
        <translation>eliminación de pesas</translation>
    </message>
    <message>
        <source>Rows copied: %1</source>
        <translation>Filas copiadas: %1</translation>
    </message>
    <message>
        <source>pasting</source>
        <translation>pegado</translation>
    </message>
    <message>
        <source>Rows pasted: %1</source>
        <translation>Filas pegadas: %1</translation>
    </message>
    <message>
        <source>Rows pasted: %1; new weights: %2</source>
        <translation>Filas pegadas: %1; pesas nuevas: %2</translation>
    </message>
    <message>
        <source>filling down</source>
        <translation>relleno hacia abajo</translation>
    </message>
    <message>
        <source>One row for each weight. Return edits a cell, of all selected rows at once.</source>
        <translation>Una fila por pesa. Intro cambia una celda, en todas las filas seleccionadas a la vez.</translation>
    </message>
</context>
<context>
    <name>ui::WindowFace</name>
    <message>
        <source>Bring them back</source>
        <translation>Recuperarlos</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Undo the change</source>
        <translation>Deshacer el cambio</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a crash: %1</source>
        <translation>Los cambios sin guardar no pueden protegerse de un fallo: %1</translation>
    </message>
    <message>
        <source>&amp;Colors</source>
        <translation>&amp;Colores</translation>
    </message>
    <message>
        <source>Like the &amp;desktop</source>
        <translation>Como el &amp;escritorio</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Tamaño del te&amp;xto</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Normal</translation>
    </message>
    <message>
        <source>&amp;Large</source>
        <translation>&amp;Grande</translation>
    </message>
    <message>
        <source>&amp;Very large</source>
        <translation>&amp;Muy grande</translation>
    </message>
    <message>
        <source>&amp;Drawn by</source>
        <translation>Di&amp;bujado por</translation>
    </message>
    <message>
        <source>&amp;Automatic choice</source>
        <translation>Elección &amp;automática</translation>
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
        <translation>Idi&amp;oma</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>No aplicado: %1</translation>
    </message>
    <message>
        <source>%1[*] – Angry Cuts</source>
        <translation>%1[*] – Angry Cuts</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Escena nueva</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Dibujado por %1</translation>
    </message>
</context>
<context>
    <name>ui::WindowPanels</name>
    <message>
        <source>Lesson</source>
        <translation>Lección</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Pesas</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Simulaciones</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Inside a step</source>
        <translation>Dentro de un paso</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Tabla de pesas</translation>
    </message>
</context>
<context>
    <name>ui::WorkPrecisionPlot</name>
    <message>
        <source>slope %1</source>
        <translation>pendiente %1</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Tiempo de cálculo por segundo simulado</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Largest position error</source>
        <translation>Mayor error de posición</translation>
    </message>
</context>
</TS>
