<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Dossier de fichiers</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Lecteur</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>Alias</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Raccourci</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Inconnu</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>Tout &amp;sélectionner</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>&amp;Augmenter</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>&amp;Diminuer</translation>
    </message>
</context>
<context>
    <name>QCommandLineParser</name>
    <message>
        <source>Unknown option &apos;%1&apos;.</source>
        <translation>Option inconnue «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Unknown options: %1.</source>
        <translation>Options inconnues&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Missing value after &apos;%1&apos;.</source>
        <translation>Valeur manquante après «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Unexpected value after &apos;%1&apos;.</source>
        <translation>Valeur inattendue après «&#xa0;%1&#xa0;».</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Voir dans&#xa0;:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Dossier&#xa0;:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>&amp;Nom du fichier&#xa0;:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Type de fichier&#xa0;:</translation>
    </message>
    <message>
        <source>Find Directory</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Revenir en arrière</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Aller en avant</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Dossier parent</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Aller au dossier parent</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Créer un nouveau dossier</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Créer un nouveau dossier</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Nouveau dossier</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Nouveau dossier</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Vue en liste</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Passer à la vue en liste</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Vue détaillée</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Passer à la vue détaillée</translation>
    </message>
    <message>
        <source>Sidebar</source>
        <translation>Barre latérale</translation>
    </message>
    <message>
        <source>List of places and bookmarks</source>
        <translation>Liste des emplacements et des signets</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Directories</source>
        <translation>Dossiers</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Emplacements récents</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Choisir</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>Suppri&amp;mer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Show </source>
        <translation>Afficher </translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>Afficher les fic&amp;hiers cachés</translation>
    </message>
    <message>
        <source>All Files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 existe déjà.
Voulez-vous le remplacer&#xa0;?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is write protected.
Do you want to delete it anyway?</source>
        <translation>«&#xa0;%1&#xa0;» est protégé en écriture.
Voulez-vous quand même le supprimer&#xa0;?</translation>
    </message>
    <message>
        <source>Are you sure you want to delete &apos;%1&apos;?</source>
        <translation>Voulez-vous vraiment supprimer «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>Could not delete directory.</source>
        <translation>Impossible de supprimer le dossier.</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Fichier introuvable.
Veuillez vérifier le nom du fichier.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Dossier introuvable.
Veuillez vérifier le nom du dossier.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Dernière modification</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordinateur</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mon ordinateur</translation>
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
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Close without Saving</source>
        <translation>Fermer sans enregistrer</translation>
    </message>
</context>
<context>
    <name>QIODevice</name>
    <message>
        <source>Permission denied</source>
        <translation>Permission refusée</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Fichier ou dossier introuvable</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Plus d’espace sur le disque</translation>
    </message>
    <message>
        <source>file to open is a directory</source>
        <translation>c’est un dossier, pas un fichier</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Co&amp;ller</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Tout sélectionner</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Show Details...</source>
        <translation>Montrer les détails…</translation>
    </message>
    <message>
        <source>Hide Details...</source>
        <translation>Masquer les détails…</translation>
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
        <translation>&amp;Oui</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>Oui à &amp;tout</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Non</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>No&amp;n à tout</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Tout enregistrer</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>Ignorer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>Valeurs par défaut</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
</context>
<context>
    <name>QSaveFile</name>
    <message>
        <source>Existing file %1 is not writable</source>
        <translation>Le fichier %1 existe et ne peut pas être modifié</translation>
    </message>
    <message>
        <source>Filename refers to a directory</source>
        <translation>Ce nom est celui d’un dossier</translation>
    </message>
</context>
<context>
    <name>QScrollBar</name>
    <message>
        <source>Scroll here</source>
        <translation>Défiler jusqu’ici</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>Bord gauche</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Right edge</source>
        <translation>Bord droit</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Page left</source>
        <translation>Page à gauche</translation>
    </message>
    <message>
        <source>Page up</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>Page right</source>
        <translation>Page à droite</translation>
    </message>
    <message>
        <source>Page down</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <source>Scroll left</source>
        <translation>Défiler vers la gauche</translation>
    </message>
    <message>
        <source>Scroll up</source>
        <translation>Défiler vers le haut</translation>
    </message>
    <message>
        <source>Scroll right</source>
        <translation>Défiler vers la droite</translation>
    </message>
    <message>
        <source>Scroll down</source>
        <translation>Défiler vers le bas</translation>
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
        <translation>Maj</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
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
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>PgPréc</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgSuiv</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page précédente</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page suivante</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Inser</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Inser</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backtab</source>
        <translation>Maj+Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Media Play</source>
        <translation>Lecture</translation>
    </message>
</context>
<context>
    <name>QTabBar</name>
    <message>
        <source>Scroll Left</source>
        <translation>Défiler vers la gauche</translation>
    </message>
    <message>
        <source>Scroll Right</source>
        <translation>Défiler vers la droite</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy &amp;Link Location</source>
        <translation>Copier l’adresse du &amp;lien</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Co&amp;ller</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Tout sélectionner</translation>
    </message>
</context>
<context>
    <name>app::Arguments</name>
    <message>
        <source>stands twice</source>
        <translation>figure deux fois</translation>
    </message>
    <message>
        <source>unexpected argument &quot;%1&quot;</source>
        <translation>argument inattendu «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>must be a number, got &quot;%1&quot;</source>
        <translation>attendu&#xa0;: un nombre&#xa0;; lu&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>doit être un nom</translation>
    </message>
</context>
<context>
    <name>app::CsvOutput</name>
    <message>
        <source>standard output</source>
        <translation>sortie standard</translation>
    </message>
</context>
<context>
    <name>app::Demonstration</name>
    <message>
        <source>every method diverged before %1 s</source>
        <translation>toutes les méthodes ont divergé avant %1 s</translation>
    </message>
    <message>
        <source>There is no display for the window, so &quot;%1&quot; was simulated for %2 s.
%3: energy with %4
%5: where every weight is, with %6
%7: the scene at %8 s
</source>
        <translation>Aucun écran pour la fenêtre&#xa0;: «&#xa0;%1&#xa0;» a donc été simulé sur %2 s.
%3&#xa0;: l’énergie avec %4
%5&#xa0;: où se trouve chaque bille, avec %6
%7&#xa0;: la scène à %8 s
</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
</context>
<context>
    <name>app::EnergyHistory</name>
    <message>
        <source>Time in s; energies in J: kinetic, potential, lost to air, to impacts, to ropes, to friction; numerical drift
</source>
        <translation>Temps en s&#xa0;; énergies en J&#xa0;: cinétique, potentielle, perdue dans l’air, dans les chocs, dans les cordes, par frottement&#xa0;; dérive numérique
</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>cinétique</translation>
    </message>
    <message>
        <source>potential</source>
        <translation>potentielle</translation>
    </message>
    <message>
        <source>air</source>
        <translation>air</translation>
    </message>
    <message>
        <source>impacts</source>
        <translation>chocs</translation>
    </message>
    <message>
        <source>ropes</source>
        <translation>cordes</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>frottement</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>dérive</translation>
    </message>
</context>
<context>
    <name>app::ExitStatus</name>
    <message>
        <source>standard output: %1</source>
        <translation>sortie standard&#xa0;: %1</translation>
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
        <translation>Utilisation&#xa0;:
  angrycuts [SCÈNE]                      ouvre la fenêtre
  angrycuts scenes [--export DOSSIER]    liste les scènes fournies, ou les écrit
                                         dans des fichiers
  angrycuts simulate SCÈNE [options]     calcule sans fenêtre
  angrycuts measure SCÈNE [options]      mesure la vitesse et la précision
  angrycuts --help, --version

Une SCÈNE est un fichier ou le nom d’une scène fournie. Sans écran,
angrycuts [SCÈNE] simule la scène avec chacune de ses méthodes et écrit les
résultats dans le dossier courant.

Options de simulate&#xa0;:
  --method NOM          %1 (rk4)
  --step SECONDES       pas de la méthode, de 1e-7 à 10 (1/60)
  --tolerance X         au lieu d’un pas pour dopri5, de 1e-14 à 1 (1e-9)
  --until SECONDES      temps simulé à atteindre, de 0 à 1e6 (10)
  --cut SECONDES|never  quand couper toutes les cordes (selon la scène)
  --sample SECONDES     temps entre les lignes, de 1e-7 à 1e6 (0.1)
  --trajectory FICHIER  où se trouve chaque bille, en CSV&#xa0;; -&#xa0;: sortie standard
  --energy FICHIER      où se trouve l’énergie, en CSV&#xa0;; -&#xa0;: sortie standard
  --events FICHIER      ce qui s’est passé, en CSV&#xa0;; -&#xa0;: sortie standard
  --chart FICHIER       le graphique de l’énergie en .png, .svg ou .pdf
Sans aucun de ces quatre fichiers, affiche un court tableau.

Options de measure, qui essaie toutes les méthodes avec beaucoup de pas&#xa0;:
  --until SECONDES      temps simulé à mesurer, de 0 à 1e6 (10)
  --cut SECONDES|never  quand couper toutes les cordes (selon la scène)
  --csv FICHIER         tous les chiffres, en CSV&#xa0;; -&#xa0;: sortie standard
  --chart FICHIER       l’erreur selon le coût en .png, .svg ou .pdf
Sans aucun de ces deux fichiers, affiche un court tableau.

Code de sortie&#xa0;: 0&#xa0;; 2 si l’appel ou la scène est refusé&#xa0;; 3 si les nombres,
ou les événements ou pas dans un seul pas, sont devenus ingérables&#xa0;; 1 pour
tout le reste, comme un disque plein.
</translation>
    </message>
</context>
<context>
    <name>app::MeasureTable</name>
    <message>
        <source>at most</source>
        <translation>au plus</translation>
    </message>
    <message>
        <source>extrapolated</source>
        <translation>extrapolé</translation>
    </message>
    <message>
        <source>method</source>
        <translation>méthode</translation>
    </message>
    <message>
        <source>order</source>
        <translation>ordre</translation>
    </message>
    <message>
        <source>least error</source>
        <translation>erreur mini</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>réglage</translation>
    </message>
    <message>
        <source>ns per s</source>
        <translation>ns par s</translation>
    </message>
    <message>
        <source>Order: the power of the step that the position error falls with. Setting (step in s, or tolerance)
and cost (ns of computing per simulated second): to be right within 1e-6 m.

</source>
        <translation>Ordre&#xa0;: la puissance du pas avec laquelle l’erreur de position diminue. Réglage (pas en s, ou
tolérance) et coût (ns de calcul par seconde simulée)&#xa0;: pour une erreur d’au plus 1e-6 m.

</translation>
    </message>
</context>
<context>
    <name>app::Options</name>
    <message>
        <source>%1 is used twice</source>
        <translation>%1 est utilisé deux fois</translation>
    </message>
    <message>
        <source>must end in .png, .svg or .pdf, got &quot;%1&quot;</source>
        <translation>doit se terminer par .png, .svg ou .pdf&#xa0;; lu&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>%1: a scene must be named</source>
        <translation>%1&#xa0;: il faut nommer une scène</translation>
    </message>
    <message>
        <source>unknown command &quot;%1&quot;</source>
        <translation>commande inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>must be one of %1, got &quot;%2&quot;</source>
        <translation>attendu&#xa0;: un nom parmi %1&#xa0;; lu&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 se règle par une tolérance, non par un pas</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 se règle par un pas, non par une tolérance</translation>
    </message>
</context>
<context>
    <name>app::ProgressLine</name>
    <message>
        <source>Measuring: %1 %</source>
        <translation>Mesure&#xa0;: %1 %</translation>
    </message>
</context>
<context>
    <name>app::ScenesCommand</name>
    <message>
        <source>%1: the folder cannot be made</source>
        <translation>%1&#xa0;: impossible de créer le dossier</translation>
    </message>
</context>
<context>
    <name>app::SimulateCommand</name>
    <message>
        <source>a larger --tolerance may help</source>
        <translation>une valeur plus grande de --tolerance peut aider</translation>
    </message>
    <message>
        <source>a smaller --tolerance may help</source>
        <translation>une valeur plus petite de --tolerance peut aider</translation>
    </message>
    <message>
        <source>a smaller --step may help</source>
        <translation>une valeur plus petite de --step peut aider</translation>
    </message>
    <message>
        <source>--step %1 works</source>
        <translation>--step %1 convient</translation>
    </message>
    <message>
        <source>the numbers stopped being finite</source>
        <translation>les nombres ne sont plus finis</translation>
    </message>
    <message>
        <source>the next step holds more events than can be followed</source>
        <translation>le pas suivant contient plus d’événements qu’on n’en peut suivre</translation>
    </message>
    <message>
        <source>the tolerance asks for more or smaller steps than can be taken</source>
        <translation>la tolérance demande des pas plus nombreux ou plus petits que possible</translation>
    </message>
    <message>
        <source>diverged at %1 s: %2; %3</source>
        <translation>diverge à %1 s&#xa0;: %2&#xa0;; %3</translation>
    </message>
</context>
<context>
    <name>app::main</name>
    <message>
        <source>the window cannot be opened: %1</source>
        <translation>la fenêtre ne peut pas s’ouvrir&#xa0;: %1</translation>
    </message>
    <message>
        <source>no display answers (%1)</source>
        <translation>aucun écran ne répond (%1)</translation>
    </message>
</context>
<context>
    <name>ui::AccuracyPanel</name>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Temps simulé</translation>
    </message>
    <message>
        <source>Error against cost</source>
        <translation>Erreur selon le coût</translation>
    </message>
    <message>
        <source>Error against step</source>
        <translation>Erreur selon le pas</translation>
    </message>
    <message>
        <source>What the chart shows</source>
        <translation>Ce que montre le graphique</translation>
    </message>
    <message>
        <source>Right within</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>Error against cost or step</source>
        <translation>Erreur selon le coût ou le pas</translation>
    </message>
    <message>
        <source>Click a point to open it as a run</source>
        <translation>Cliquez sur un point pour l’ouvrir comme simulation</translation>
    </message>
    <message>
        <source>Measures every method at steps from 1/8 to 1/8192 s: how far the weights are from where they really are, and what that costs. Takes some seconds.</source>
        <translation>Mesure chaque méthode avec des pas de 1/8 à 1/8192 s&#xa0;: à quelle distance les billes sont de leur vraie position, et ce que cela coûte. Prend quelques secondes.</translation>
    </message>
    <message>
        <source>accuracy</source>
        <translation>precision</translation>
    </message>
    <message>
        <source>How long each run is followed, in s; errors are compared at its end</source>
        <translation>Durée pendant laquelle chaque simulation est suivie, en s&#xa0;; les erreurs sont comparées à la fin</translation>
    </message>
    <message>
        <source>Cost is counted in slope evaluations, which the time of computing goes with</source>
        <translation>Le coût se compte en évaluations de pente, que suit le temps de calcul</translation>
    </message>
    <message>
        <source>Largest distance from the true place that is accepted, in m: which method reaches it at the lowest cost?</source>
        <translation>Plus grande distance acceptée à la vraie position, en m&#xa0;: quelle méthode l’atteint au moindre coût&#xa0;?</translation>
    </message>
</context>
<context>
    <name>ui::BuiltInScenes</name>
    <message>
        <source>no file or built-in scene of that name</source>
        <translation>aucun fichier ni scène fournie de ce nom</translation>
    </message>
</context>
<context>
    <name>ui::ChartFile</name>
    <message>
        <source>a chart&apos;s file ends in .png, .svg or .pdf</source>
        <translation>le fichier d’un graphique se termine par .png, .svg ou .pdf</translation>
    </message>
</context>
<context>
    <name>ui::ChartKind</name>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Energies over time</source>
        <translation>Énergies au cours du temps</translation>
    </message>
    <message>
        <source>Ledger</source>
        <translation>Bilan</translation>
    </message>
    <message>
        <source>Where the energy is and went, stacked</source>
        <translation>Où l’énergie se trouve et où elle est passée, empilé</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Phase portrait: angular velocity against angle</source>
        <translation>Portrait de phase&#xa0;: vitesse angulaire selon l’angle</translation>
    </message>
    <message>
        <source>Paths</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Paths of the weights: y against x</source>
        <translation>Trajectoires des billes&#xa0;: y selon x</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height above the floor over time</source>
        <translation>Hauteur au-dessus du sol au cours du temps</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed over time</source>
        <translation>Vitesse au cours du temps</translation>
    </message>
</context>
<context>
    <name>ui::ChartOverlay</name>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
</context>
<context>
    <name>ui::ChartReadings</name>
    <message>
        <source>%1; %2</source>
        <translation>%1&#xa0;; %2</translation>
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
        <translation>Largeur de page</translation>
    </message>
    <message>
        <source>Half the page width</source>
        <translation>Demi-largeur de page</translation>
    </message>
    <message>
        <source>Slide, 16:9</source>
        <translation>Diapositive, 16:9</translation>
    </message>
    <message>
        <source>Poster, A3</source>
        <translation>Affiche, A3</translation>
    </message>
    <message>
        <source>Size of the chart</source>
        <translation>Taille du graphique</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Taille libre</translation>
    </message>
    <message>
        <source>&amp;For</source>
        <translation>&amp;Pour</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Hauteur</translation>
    </message>
    <message>
        <source>Sizes that are often wanted</source>
        <translation>Tailles souvent demandées</translation>
    </message>
    <message>
        <source>Width of the chart on paper, in mm</source>
        <translation>Largeur du graphique sur papier, en mm</translation>
    </message>
    <message>
        <source>Height of the chart on paper, in mm</source>
        <translation>Hauteur du graphique sur papier, en mm</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Usage</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
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
        <translation>Temps</translation>
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
        <translation>Un clic va à un instant. La molette, plus et moins zooment, un cadre tracé aussi&#xa0;; Alt et les flèches déplacent le graphique, 0 le montre en entier.</translation>
    </message>
</context>
<context>
    <name>ui::ChartsPanel</name>
    <message>
        <source>Kind of chart</source>
        <translation>Type de graphique</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Bille </translation>
    </message>
    <message>
        <source>Weight in the chart</source>
        <translation>Bille du graphique</translation>
    </message>
    <message>
        <source>Weight in the chart, counted from the left; 0: all</source>
        <translation>Bille du graphique, comptée depuis la gauche&#xa0;; 0&#xa0;: toutes</translation>
    </message>
    <message>
        <source>Runs in the chart</source>
        <translation>Simulations du graphique</translation>
    </message>
    <message>
        <source>Chart menu</source>
        <translation>Menu du graphique</translation>
    </message>
    <message>
        <source>Zoom, copy, export, hide curves</source>
        <translation>Zoomer, copier, exporter, masquer des courbes</translation>
    </message>
    <message>
        <source>&amp;Curves</source>
        <translation>Cou&amp;rbes</translation>
    </message>
    <message>
        <source>All runs</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>What the chart shows against what</source>
        <translation>Ce que le graphique montre en fonction de quoi</translation>
    </message>
</context>
<context>
    <name>ui::Commands</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>Start with one weight in an empty room</source>
        <translation>Commencer avec une bille dans une pièce vide</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open a scene file</source>
        <translation>Ouvrir un fichier de scène</translation>
    </message>
    <message>
        <source>&amp;Lessons…</source>
        <translation>&amp;Leçons…</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>Choose one of the built-in scenes by its picture</source>
        <translation>Choisir l’une des scènes fournies par son image</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Enregistrer la scène</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save the scene in another file</source>
        <translation>Enregistrer la scène dans un autre fichier</translation>
    </message>
    <message>
        <source>&amp;Export chart…</source>
        <translation>E&amp;xporter le graphique…</translation>
    </message>
    <message>
        <source>Save the chart as a PNG, SVG or PDF picture</source>
        <translation>Enregistrer le graphique en image PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>Export &amp;picture of the scene…</source>
        <translation>Exporter une &amp;image…</translation>
    </message>
    <message>
        <source>Save what is shown as a PNG, SVG or PDF picture</source>
        <translation>Enregistrer ce qui est montré en image PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Take back the last change of the scene</source>
        <translation>Annuler le dernier changement de la scène</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Make the change again that was taken back last</source>
        <translation>Rétablir le dernier changement annulé</translation>
    </message>
    <message>
        <source>&amp;Weights table</source>
        <translation>&amp;Tableau des billes</translation>
    </message>
    <message>
        <source>All weights in a table, to be changed many at once</source>
        <translation>Toutes les billes dans un tableau, pour en changer beaucoup à la fois</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Let time pass, or stop it</source>
        <translation>Laisser passer le temps, ou l’arrêter</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>A&amp;vancer d’un pas</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Take one integration step of the first run</source>
        <translation>Faire un pas d’intégration de la première simulation</translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation>&amp;Reculer d’un pas</translation>
    </message>
    <message>
        <source>Go back by one integration step of the first run</source>
        <translation>Revenir d’un pas d’intégration de la première simulation</translation>
    </message>
    <message>
        <source>Step one &amp;frame</source>
        <translation>Avancer d’une &amp;image</translation>
    </message>
    <message>
        <source>Go on by 1/60 s, times the speed</source>
        <translation>Avancer de 1/60 s, multiplié par la vitesse</translation>
    </message>
    <message>
        <source>Step a f&amp;rame back</source>
        <translation>Reculer d’une ima&amp;ge</translation>
    </message>
    <message>
        <source>Go back by 1/60 s, times the speed</source>
        <translation>Reculer de 1/60 s, multiplié par la vitesse</translation>
    </message>
    <message>
        <source>&amp;Cut the ropes</source>
        <translation>&amp;Couper les cordes</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Cut all ropes now</source>
        <translation>Couper maintenant toutes les cordes</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Recomme&amp;ncer</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Go back to the start</source>
        <translation>Revenir au début</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Ralen&amp;tir</translation>
    </message>
    <message>
        <source>Halve the speed</source>
        <translation>Diviser la vitesse par deux</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>Accélér&amp;er</translation>
    </message>
    <message>
        <source>Double the speed</source>
        <translation>Doubler la vitesse</translation>
    </message>
    <message>
        <source>Split &amp;views</source>
        <translation>&amp;Vues séparées</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Séparer</translation>
    </message>
    <message>
        <source>Give each run a view of its own</source>
        <translation>Donner à chaque simulation sa propre vue</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>Évé&amp;nement suivant</translation>
    </message>
    <message>
        <source>Go to the next event of any kind</source>
        <translation>Aller au prochain événement, quel qu’il soit</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>Événement pré&amp;cédent</translation>
    </message>
    <message>
        <source>Go back to the event before</source>
        <translation>Revenir à l’événement précédent</translation>
    </message>
    <message>
        <source>Next &amp;impact</source>
        <translation>Choc &amp;suivant</translation>
    </message>
    <message>
        <source>Go on until something is hit</source>
        <translation>Avancer jusqu’au prochain choc</translation>
    </message>
    <message>
        <source>Previous i&amp;mpact</source>
        <translation>Choc &amp;précédent</translation>
    </message>
    <message>
        <source>Go back to the impact before</source>
        <translation>Revenir au choc précédent</translation>
    </message>
    <message>
        <source>Next &amp;turning point</source>
        <translation>&amp;Rebroussement suivant</translation>
    </message>
    <message>
        <source>Go on until a weight turns round on its rope</source>
        <translation>Avancer jusqu’à ce qu’une bille rebrousse chemin sur sa corde</translation>
    </message>
    <message>
        <source>Previous t&amp;urning point</source>
        <translation>Re&amp;broussement précédent</translation>
    </message>
    <message>
        <source>Go back to the turning point before</source>
        <translation>Revenir au point de rebroussement précédent</translation>
    </message>
    <message>
        <source>Next &amp;cut</source>
        <translation>Coupe suiv&amp;ante</translation>
    </message>
    <message>
        <source>Go on until ropes are cut</source>
        <translation>Avancer jusqu’à la prochaine coupe de cordes</translation>
    </message>
    <message>
        <source>Previous cu&amp;t</source>
        <translation>Coupe précé&amp;dente</translation>
    </message>
    <message>
        <source>Go back to the cut before</source>
        <translation>Revenir à la coupe précédente</translation>
    </message>
    <message>
        <source>&amp;Start of the recording</source>
        <translation>Début de l’&amp;enregistrement</translation>
    </message>
    <message>
        <source>Show the start again; what is recorded stays</source>
        <translation>Remontrer le début&#xa0;; ce qui est enregistré reste</translation>
    </message>
    <message>
        <source>&amp;End of the recording</source>
        <translation>&amp;Fin de l’enregistrement</translation>
    </message>
    <message>
        <source>Show the last moment that is computed</source>
        <translation>Montrer le dernier instant calculé</translation>
    </message>
    <message>
        <source>&amp;Go to a time…</source>
        <translation>Aller à un &amp;instant…</translation>
    </message>
    <message>
        <source>Show any moment, and compute it first where needed</source>
        <translation>Montrer un instant quelconque, en le calculant d’abord si nécessaire</translation>
    </message>
    <message>
        <source>Stop &amp;on the way</source>
        <translation>S’arrêter en c&amp;hemin</translation>
    </message>
    <message>
        <source>Stay at the moment that the computing has come to</source>
        <translation>Rester à l’instant que le calcul a atteint</translation>
    </message>
    <message>
        <source>Speed and &amp;accuracy…</source>
        <translation>Vitesse et précisi&amp;on…</translation>
    </message>
    <message>
        <source>Measure what accuracy costs, and how large steps may be</source>
        <translation>Mesurer ce que coûte la précision, et combien les pas peuvent être grands</translation>
    </message>
    <message>
        <source>&amp;When to cut?…</source>
        <translation>&amp;Quand couper&#xa0;?…</translation>
    </message>
    <message>
        <source>Find the moments to cut at that hit the target</source>
        <translation>Trouver les instants de coupe qui touchent la cible</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>&amp;Traces</translation>
    </message>
    <message>
        <source>Show where the weights have just been</source>
        <translation>Montrer où les billes viennent de passer</translation>
    </message>
    <message>
        <source>V&amp;elocities</source>
        <translation>Vit&amp;esses</translation>
    </message>
    <message>
        <source>Show how fast the weights move, and where to, as arrows</source>
        <translation>Montrer par des flèches à quelle vitesse et vers où vont les billes</translation>
    </message>
    <message>
        <source>Fo&amp;rces</source>
        <translation>&amp;Forces</translation>
    </message>
    <message>
        <source>Show gravity, air drag and the pull of the rope as arrows</source>
        <translation>Montrer par des flèches le poids, la résistance de l’air et la tension de la corde</translation>
    </message>
    <message>
        <source>Te&amp;nsions</source>
        <translation>Te&amp;nsions</translation>
    </message>
    <message>
        <source>Show in newtons how hard each rope pulls</source>
        <translation>Montrer en newtons la tension de chaque corde</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Règle</translation>
    </message>
    <message>
        <source>Measure a length in the scene</source>
        <translation>Mesurer une longueur dans la scène</translation>
    </message>
    <message>
        <source>&amp;Protractor</source>
        <translation>Ra&amp;pporteur</translation>
    </message>
    <message>
        <source>Measure an angle in the scene</source>
        <translation>Mesurer un angle dans la scène</translation>
    </message>
    <message>
        <source>&amp;Stopwatch</source>
        <translation>&amp;Chronomètre</translation>
    </message>
    <message>
        <source>Measure simulated time</source>
        <translation>Mesurer le temps simulé</translation>
    </message>
    <message>
        <source>S&amp;tart or stop the stopwatch</source>
        <translation>&amp;Démarrer/arrêter le chrono</translation>
    </message>
    <message>
        <source>Start the stopwatch at the moment shown, or stop it</source>
        <translation>Démarrer le chronomètre à l’instant montré, ou l’arrêter</translation>
    </message>
    <message>
        <source>Stopwatch to &amp;zero</source>
        <translation>Chrono à &amp;zéro</translation>
    </message>
    <message>
        <source>Set the stopwatch back to zero</source>
        <translation>Remettre le chronomètre à zéro</translation>
    </message>
    <message>
        <source>&amp;Next handle</source>
        <translation>Poignée &amp;suivante</translation>
    </message>
    <message>
        <source>Choose what Alt and the arrow keys move: an end of the ruler, an arm of the protractor …</source>
        <translation>Choisir ce que déplacent Alt et les flèches&#xa0;: un bout de la règle, un bras du rapporteur…</translation>
    </message>
    <message>
        <source>Tar&amp;get</source>
        <translation>&amp;Cible</translation>
    </message>
    <message>
        <source>Show a target on the floor; drag it to where it shall be</source>
        <translation>Montrer une cible au sol&#xa0;; la glisser où l’on veut</translation>
    </message>
    <message>
        <source>&amp;Lesson text</source>
        <translation>Texte de la &amp;leçon</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>Show what to look for and what to try, or hide it</source>
        <translation>Montrer ce qu’il faut observer et essayer, ou le masquer</translation>
    </message>
    <message>
        <source>&amp;Fit the room</source>
        <translation>Cadre&amp;r la pièce</translation>
    </message>
    <message>
        <source>Show the whole room</source>
        <translation>Montrer toute la pièce</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Zoom &amp;avant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom arr&amp;ière</translation>
    </message>
    <message>
        <source>&amp;Next weight</source>
        <translation>Bille &amp;suivante</translation>
    </message>
    <message>
        <source>Select the next weight</source>
        <translation>Sélectionner la bille suivante</translation>
    </message>
    <message>
        <source>&amp;Previous weight</source>
        <translation>Bille &amp;précédente</translation>
    </message>
    <message>
        <source>Select the weight before</source>
        <translation>Sélectionner la bille précédente</translation>
    </message>
    <message>
        <source>Select n&amp;one</source>
        <translation>Ne ri&amp;en sélectionner</translation>
    </message>
    <message>
        <source>Select no weight and no handle any more</source>
        <translation>Ne plus sélectionner ni bille ni poignée</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>Déplacer à &amp;gauche</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the left, or move the weight or handle</source>
        <translation>Tourner la corde de la bille sélectionnée vers la gauche, ou déplacer la bille ou la poignée</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>Déplacer à d&amp;roite</translation>
    </message>
    <message>
        <source>Turn the rope of the selected weight to the right, or move the weight or handle</source>
        <translation>Tourner la corde de la bille sélectionnée vers la droite, ou déplacer la bille ou la poignée</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>Déplacer vers le &amp;haut</translation>
    </message>
    <message>
        <source>Shorten the rope of the selected weight, or move the weight or handle up</source>
        <translation>Raccourcir la corde de la bille sélectionnée, ou monter la bille ou la poignée</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>Déplacer vers le &amp;bas</translation>
    </message>
    <message>
        <source>Lengthen the rope of the selected weight, or move the weight or handle down</source>
        <translation>Allonger la corde de la bille sélectionnée, ou descendre la bille ou la poignée</translation>
    </message>
    <message>
        <source>Faster l&amp;eft</source>
        <translation>Plus vite à g&amp;auche</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the left</source>
        <translation>Augmenter vers la gauche la vitesse de la bille sélectionnée</translation>
    </message>
    <message>
        <source>Faster r&amp;ight</source>
        <translation>Plus vite à dr&amp;oite</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight towards the right</source>
        <translation>Augmenter vers la droite la vitesse de la bille sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Faster up</source>
        <translation>Plus vite vers le ha&amp;ut</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight upwards</source>
        <translation>Augmenter vers le haut la vitesse de la bille sélectionnée</translation>
    </message>
    <message>
        <source>Fa&amp;ster down</source>
        <translation>Plus &amp;vite vers le bas</translation>
    </message>
    <message>
        <source>Add to the speed of the selected weight downwards</source>
        <translation>Augmenter vers le bas la vitesse de la bille sélectionnée</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>Pré&amp;senter</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Présenter</translation>
    </message>
    <message>
        <source>Fill the screen with the scene and one chart, in large type</source>
        <translation>Remplir l’écran avec la scène et un graphique, en grands caractères</translation>
    </message>
    <message>
        <source>&amp;Next chart</source>
        <translation>Graphique &amp;suivant</translation>
    </message>
    <message>
        <source>Show the next kind of chart</source>
        <translation>Montrer le type de graphique suivant</translation>
    </message>
    <message>
        <source>&amp;Previous chart</source>
        <translation>Graphique &amp;précédent</translation>
    </message>
    <message>
        <source>Show the previous kind of chart</source>
        <translation>Montrer le type de graphique précédent</translation>
    </message>
    <message>
        <source>&amp;Whole chart</source>
        <translation>Graphique en &amp;entier</translation>
    </message>
    <message>
        <source>Show all of the chart again after zooming</source>
        <translation>Remontrer tout le graphique après un zoom</translation>
    </message>
    <message>
        <source>&amp;Copy chart</source>
        <translation>&amp;Copier le graphique</translation>
    </message>
    <message>
        <source>Copy the chart as a picture for paper</source>
        <translation>Copier le graphique en image pour le papier</translation>
    </message>
    <message>
        <source>Copy chart &amp;data</source>
        <translation>Copier les &amp;données</translation>
    </message>
    <message>
        <source>Copy the chart&apos;s curves as a table for a spreadsheet</source>
        <translation>Copier les courbes du graphique en tableau pour un tableur</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>List all keys</source>
        <translation>Afficher tous les raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;About Angry Cuts</source>
        <translation>À &amp;propos d’Angry Cuts</translation>
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
        <translation>Fiche de l’&amp;enseignant</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Fiche</translation>
    </message>
    <message>
        <source>Goal, steps, questions and expected figures of this lesson, to be printed</source>
        <translation>But, étapes, questions et valeurs attendues de cette leçon, à imprimer</translation>
    </message>
    <message>
        <source>Quick &amp;guide</source>
        <translation>&amp;Guide rapide</translation>
    </message>
    <message>
        <source>Explain the window in a few pages</source>
        <translation>Expliquer la fenêtre en quelques pages</translation>
    </message>
    <message>
        <source>The &amp;model</source>
        <translation>Le &amp;modèle</translation>
    </message>
    <message>
        <source>Show the equations that are computed, and why</source>
        <translation>Montrer les équations calculées, et pourquoi</translation>
    </message>
    <message>
        <source>T&amp;our of the window</source>
        <translation>&amp;Visite de la fenêtre</translation>
    </message>
    <message>
        <source>Point out the five most important parts of the window</source>
        <translation>Montrer les cinq parties les plus importantes de la fenêtre</translation>
    </message>
</context>
<context>
    <name>ui::ComparisonPanel</name>
    <message>
        <source>Run that distances are measured from</source>
        <translation>Simulation à partir de laquelle on mesure les distances</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Apart (m)</source>
        <translation>Écart (m)</translation>
    </message>
    <message>
        <source>Drift (J)</source>
        <translation>Dérive (J)</translation>
    </message>
    <message>
        <source>Drift (%)</source>
        <translation>Dérive (%)</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Pentes</translation>
    </message>
    <message>
        <source>The same as a share of the energy at the start</source>
        <translation>La même, en part de l’énergie de départ</translation>
    </message>
    <message>
        <source>Slope evaluations so far</source>
        <translation>Évaluations de pente jusqu’ici</translation>
    </message>
    <message>
        <source>Runs in figures</source>
        <translation>Les simulations en chiffres</translation>
    </message>
    <message>
        <source>Distance from %1</source>
        <translation>Distance à %1</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, now: max |p − p&apos;|, in m</source>
        <translation>Plus grande distance entre la même bille des deux simulations, maintenant&#xa0;: max |p − p’|, en m</translation>
    </message>
    <message>
        <source>Energy the method got wrong so far, in J: kinetic + potential + losses − energy at the start</source>
        <translation>Énergie que la méthode a faussée jusqu’ici, en J&#xa0;: cinétique + potentielle + pertes − énergie au départ</translation>
    </message>
    <message>
        <source>Method and step of the run</source>
        <translation>Méthode et pas de la simulation</translation>
    </message>
    <message>
        <source>How far the runs are apart, and what each got wrong, at the moment shown</source>
        <translation>Écart entre les simulations et erreur de chacune, à l’instant montré</translation>
    </message>
</context>
<context>
    <name>ui::CutQuestions</name>
    <message>
        <source>Cut between</source>
        <translation>Couper entre</translation>
    </message>
    <message>
        <source>and</source>
        <translation>et</translation>
    </message>
    <message>
        <source>Weight that is to hit the target</source>
        <translation>Bille qui doit toucher la cible</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Quelle bille, comptée depuis la gauche</translation>
    </message>
    <message>
        <source>Method that finds the moments</source>
        <translation>Méthode qui cherche les instants</translation>
    </message>
    <message>
        <source>Center of the target</source>
        <translation>Centre de la cible</translation>
    </message>
    <message>
        <source>Where the middle of the target lies, x in m from the left wall</source>
        <translation>Position du milieu de la cible, x en m depuis le mur gauche</translation>
    </message>
    <message>
        <source>Width of the target</source>
        <translation>Largeur de la cible</translation>
    </message>
    <message>
        <source>How wide the target is, in m</source>
        <translation>Largeur de la cible, en m</translation>
    </message>
    <message>
        <source>First cut time</source>
        <translation>Premier instant de coupe</translation>
    </message>
    <message>
        <source>The earliest moment to cut, in s</source>
        <translation>Le premier instant de coupe, en s</translation>
    </message>
    <message>
        <source>Last cut time</source>
        <translation>Dernier instant de coupe</translation>
    </message>
    <message>
        <source>The latest moment to cut, in s</source>
        <translation>Le dernier instant de coupe, en s</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Bille</translation>
    </message>
    <message>
        <source>by</source>
        <translation>par</translation>
    </message>
    <message>
        <source>Target at</source>
        <translation>Cible à</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>must be later than the first</source>
        <translation>doit être après le premier</translation>
    </message>
</context>
<context>
    <name>ui::CutResults</name>
    <message>
        <source>when-to-cut</source>
        <translation>quand-couper</translation>
    </message>
    <message>
        <source>Copy chart</source>
        <translation>Copier le graphique</translation>
    </message>
    <message>
        <source>Copy chart data</source>
        <translation>Copier les données</translation>
    </message>
    <message>
        <source>Finds where the weight first comes to the floor for every moment of the cut, and the moments that hit the target.</source>
        <translation>Cherche, pour chaque instant de coupe, où la bille arrive d’abord au sol, et les instants qui touchent la cible.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweep</name>
    <message>
        <source>straight to the floor</source>
        <translation>droit au sol</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Weight %1 never comes to the floor.</source>
        <translation>La bille %1 n’arrive jamais au sol.</translation>
    </message>
    <message>
        <source>No cut makes weight %1 hit the target. The nearest is %2 m off, cut at %3 s.</source>
        <translation>Aucune coupe n’envoie la bille %1 sur la cible. Au plus près, elle tombe à %2 m, coupée à %3 s.</translation>
    </message>
    <message>
        <source>off a wall</source>
        <translation>rebond sur un mur</translation>
    </message>
    <message>
        <source>off a weight</source>
        <translation>rebond sur une bille</translation>
    </message>
    <message>
        <source>Weight %1, %2</source>
        <translation>Bille %1, %2</translation>
    </message>
    <message>
        <source>; the run cannot go on to the end</source>
        <translation>&#xa0;; la simulation ne peut aller jusqu’au bout</translation>
    </message>
    <message>
        <source>; there are more jumps than can be told apart</source>
        <translation>&#xa0;; il y a plus de sauts qu’on n’en peut distinguer</translation>
    </message>
    <message>
        <source>Of the cut times from %1 s to %2 s, %3 % hit the target. Click the chart, or double-click a row, to cut then.</source>
        <translation>Parmi les instants de coupe de %1 s à %2 s, %3 % touchent la cible. Cliquez sur le graphique, ou double-cliquez sur une ligne, pour couper à cet instant.</translation>
    </message>
    <message>
        <source>Cut (s)</source>
        <translation>Coupe (s)</translation>
    </message>
    <message>
        <source>Lands at (m)</source>
        <translation>Point de chute (m)</translation>
    </message>
    <message>
        <source>Landing (s)</source>
        <translation>Arrivée (s)</translation>
    </message>
    <message>
        <source>On the way</source>
        <translation>En chemin</translation>
    </message>
    <message>
        <source>On the target</source>
        <translation>Sur la cible</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepChart</name>
    <message>
        <source>Landing place against cut time</source>
        <translation>Point de chute selon l’instant de coupe</translation>
    </message>
    <message>
        <source>cut at %1 s</source>
        <translation>coupe à %1 s</translation>
    </message>
    <message>
        <source>does not land</source>
        <translation>n’arrive pas au sol</translation>
    </message>
    <message>
        <source>lands at %1 m</source>
        <translation>tombe à %1 m</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>après %1 s</translation>
    </message>
    <message>
        <source>A click cuts the ropes at that moment; moments that hit are listed in the table beside it.</source>
        <translation>Un clic coupe les cordes à cet instant&#xa0;; les instants qui touchent la cible sont dans le tableau à côté.</translation>
    </message>
</context>
<context>
    <name>ui::CutSweepPlot</name>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>hits it</source>
        <translation>touche</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Instant de coupe</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Lands at</source>
        <translation>Point de chute</translation>
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
        <translation>Chercher</translation>
    </message>
    <message>
        <source>When to cut?</source>
        <translation>Quand couper&#xa0;?</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>changement de la coupe</translation>
    </message>
    <message>
        <source>All ropes are cut at %1 s now. Play to see where weight %2 lands.</source>
        <translation>Toutes les cordes sont maintenant coupées à %1 s. Lancez la lecture pour voir où tombe la bille %2.</translation>
    </message>
</context>
<context>
    <name>ui::DraftKeeper</name>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>impossible de créer le dossier %1</translation>
    </message>
    <message>
        <source>nothing can be written to %1</source>
        <translation>impossible d’écrire dans %1</translation>
    </message>
</context>
<context>
    <name>ui::EnergyChart</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>drift %1 J</source>
        <translation>dérive %1 J</translation>
    </message>
    <message>
        <source>drift %1 J (%2 %)</source>
        <translation>dérive %1 J (%2 %)</translation>
    </message>
    <message>
        <source>drift %1 J (%1 %)</source>
        <translation>dérive %1 J (%1 %)</translation>
    </message>
    <message>
        <source>%1 reaches %2 J</source>
        <translation>%1 atteint %2 J</translation>
    </message>
    <message>
        <source>Scale ends at %1 %2: %3.</source>
        <translation>L’échelle s’arrête à %1 %2&#xa0;: %3.</translation>
    </message>
    <message>
        <source> − %1 %2</source>
        <translation> − %1 %2</translation>
    </message>
    <message>
        <source>Numerical drift</source>
        <translation>Dérive numérique</translation>
    </message>
    <message>
        <source>At the start</source>
        <translation>Au départ</translation>
    </message>
    <message>
        <source>Kinetic</source>
        <translation>Cinétique</translation>
    </message>
    <message>
        <source>Potential</source>
        <translation>Potentielle</translation>
    </message>
    <message>
        <source>Lost to air</source>
        <translation>Perdue (air)</translation>
    </message>
    <message>
        <source>Lost to impacts</source>
        <translation>Perdue (chocs)</translation>
    </message>
    <message>
        <source>Lost to ropes</source>
        <translation>Perdue (cordes)</translation>
    </message>
    <message>
        <source>Lost to friction</source>
        <translation>Perdue (frottement)</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totale</translation>
    </message>
</context>
<context>
    <name>ui::EventNavigator</name>
    <message>
        <source>%1: none between %2 s and %3 s.</source>
        <translation>%1&#xa0;: rien entre %2 s et %3 s.</translation>
    </message>
</context>
<context>
    <name>ui::EventTable</name>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Bille</translation>
    </message>
    <message>
        <source>Before (m/s)</source>
        <translation>Avant (m/s)</translation>
    </message>
    <message>
        <source>After (m/s)</source>
        <translation>Après (m/s)</translation>
    </message>
    <message>
        <source>Energy lost (J)</source>
        <translation>Énergie perdue (J)</translation>
    </message>
    <message>
        <source>When it happened, t in s</source>
        <translation>Quand cela s’est passé, t en s</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s’est passé</translation>
    </message>
    <message>
        <source>The weights it happened to, counted from the left</source>
        <translation>Les billes concernées, comptées depuis la gauche</translation>
    </message>
    <message>
        <source>Speed |v| right before, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Vitesse |v| juste avant, en m/s. Celle de la bille&#xa0;; si deux billes se heurtent, celle de la première nommée</translation>
    </message>
    <message>
        <source>Speed |v| right after, in m/s. Of the weight; where two meet, of the first named</source>
        <translation>Vitesse |v| juste après, en m/s. Celle de la bille&#xa0;; si deux billes se heurtent, celle de la première nommée</translation>
    </message>
    <message>
        <source>Kinetic energy turned into heat by the event, in J. Between two weights ½ (1 − e²) μ v², with the speed v towards each other and 1/μ = 1/m₁ + 1/m₂</source>
        <translation>Énergie cinétique que l’événement transforme en chaleur, en J. Entre deux billes ½ (1 − e²) μ v², avec la vitesse de rapprochement v et 1/μ = 1/m₁ + 1/m₂</translation>
    </message>
</context>
<context>
    <name>ui::EventWords</name>
    <message>
        <source>All events</source>
        <translation>Tous les événements</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Chocs</translation>
    </message>
    <message>
        <source>Turning points</source>
        <translation>Rebroussements</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Ropes slack and taut</source>
        <translation>Cordes détendues, tendues</translation>
    </message>
    <message>
        <source>Coming to rest</source>
        <translation>Mises au repos</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Turning point</source>
        <translation>Rebroussement</translation>
    </message>
    <message>
        <source>Rope slack</source>
        <translation>Corde détendue</translation>
    </message>
    <message>
        <source>Rope taut</source>
        <translation>Corde tendue</translation>
    </message>
    <message>
        <source>Impact on the floor</source>
        <translation>Choc au sol</translation>
    </message>
    <message>
        <source>Impact on the ceiling</source>
        <translation>Choc au plafond</translation>
    </message>
    <message>
        <source>Impact on the left wall</source>
        <translation>Choc au mur gauche</translation>
    </message>
    <message>
        <source>Impact on the right wall</source>
        <translation>Choc au mur droit</translation>
    </message>
    <message>
        <source>Impact of weights</source>
        <translation>Choc de billes</translation>
    </message>
    <message>
        <source>Comes to rest</source>
        <translation>Mise au repos</translation>
    </message>
    <message>
        <source>all</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
</context>
<context>
    <name>ui::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Kinds of events</source>
        <translation>Types d’événements affichés</translation>
    </message>
    <message>
        <source>Weight whose events are listed</source>
        <translation>Bille dont les événements sont listés</translation>
    </message>
    <message>
        <source>Weight whose events are listed, counted from the left</source>
        <translation>Bille dont les événements sont listés, comptée depuis la gauche</translation>
    </message>
    <message>
        <source>All weights</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Weight </source>
        <translation>Bille </translation>
    </message>
    <message>
        <source>Run whose events are listed</source>
        <translation>Simulation dont les événements sont listés</translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation>Copier en CSV</translation>
    </message>
    <message>
        <source>Copy the chosen events as CSV, or all that are listed (Ctrl+C)</source>
        <translation>Copier en CSV les événements choisis, ou tous ceux de la liste (Ctrl+C)</translation>
    </message>
    <message>
        <source>Events copied as CSV: %1</source>
        <translation>Événements copiés en CSV&#xa0;: %1</translation>
    </message>
    <message>
        <source>What happened in the run; choosing an event shows its moment</source>
        <translation>Ce qui s’est passé dans la simulation&#xa0;; choisir un événement montre son instant</translation>
    </message>
    <message>
        <source>Kinds of events that are listed</source>
        <translation>Types d’événements affichés</translation>
    </message>
</context>
<context>
    <name>ui::ExportButton</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Save the chart as a picture or its figures as a table</source>
        <translation>Enregistrer le graphique en image ou ses valeurs en tableau</translation>
    </message>
    <message>
        <source>Chart…</source>
        <translation>Graphique…</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Exporter le graphique</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tableau…</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Exporter le tableau</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
</context>
<context>
    <name>ui::Exports</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Image PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Dessin SVG (*.svg)</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export chart</source>
        <translation>Exporter le graphique</translation>
    </message>
    <message>
        <source>Export picture of the scene</source>
        <translation>Exporter une image de la scène</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>scene</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energie</translation>
    </message>
    <message>
        <source>Export energy ledger</source>
        <translation>Exporter le bilan d’énergie</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Not exported</source>
        <translation>Non exporté</translation>
    </message>
    <message>
        <source>%1 was not written:
%2</source>
        <translation>%1 n’a pas été écrit&#xa0;:
%2</translation>
    </message>
</context>
<context>
    <name>ui::FileDialog</name>
    <message>
        <source>scene</source>
        <translation>scene</translation>
    </message>
</context>
<context>
    <name>ui::FirstScene</name>
    <message>
        <source>The scene of last time, %1, was not opened: %2</source>
        <translation>La scène de la dernière fois, %1, n’a pas été ouverte&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ui::Form</name>
    <message>
        <source>change of %1</source>
        <translation>changement (%1)</translation>
    </message>
</context>
<context>
    <name>ui::HelpDialogs</name>
    <message>
        <source>Keys</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>About Angry Cuts</source>
        <translation>À propos d’Angry Cuts</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Weights hang on ropes and swing; the ropes are cut; the weights fly, bounce and come to rest. Two numerical methods compute the same scene side by side, and an energy ledger shows what each of them gets wrong.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Angry Cuts %1&lt;/h3&gt;&lt;p&gt;Des billes accrochées à des cordes se balancent&#xa0;; on coupe les cordes&#xa0;; les billes volent, rebondissent et s’immobilisent. Deux méthodes numériques calculent la même scène côte à côte, et un bilan d’énergie montre ce que chacune calcule mal.&lt;/p&gt;&lt;p&gt;Logiciel libre sous licence publique générale GNU, version 3 ou ultérieure.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Quick guide</source>
        <translation>Guide rapide</translation>
    </message>
    <message>
        <source>The model</source>
        <translation>Le modèle</translation>
    </message>
    <message>
        <source>Teacher&apos;s sheets</source>
        <translation>Fiches de l’enseignant</translation>
    </message>
    <message>
        <source>Chapters</source>
        <translation>Chapitres</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Im&amp;primer…</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>&amp;Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Printed %1</source>
        <translation>%1 imprimé</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Enregistrer en PDF</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Non enregistré</translation>
    </message>
    <message>
        <source>Guide, model or teacher&apos;s sheets</source>
        <translation>Guide, modèle ou fiches de l’enseignant</translation>
    </message>
    <message>
        <source>What this chapter has; the one chosen is shown</source>
        <translation>Ce que contient ce chapitre&#xa0;; l’élément choisi est affiché</translation>
    </message>
    <message>
        <source>The page that is open</source>
        <translation>La page ouverte</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Fermer cette fenêtre</translation>
    </message>
    <message>
        <source>Print these pages, black on white</source>
        <translation>Imprimer ces pages, en noir sur blanc</translation>
    </message>
    <message>
        <source>Save these pages as a file</source>
        <translation>Enregistrer ces pages dans un fichier</translation>
    </message>
</context>
<context>
    <name>ui::HitTable</name>
    <message>
        <source>wall</source>
        <translation>mur</translation>
    </message>
    <message>
        <source>weight</source>
        <translation>bille</translation>
    </message>
    <message>
        <source>Cut at</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Lands</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>Off a</source>
        <translation>Rebond</translation>
    </message>
    <message>
        <source>The moment that comes nearest to the target&apos;s center</source>
        <translation>L’instant qui arrive le plus près du centre de la cible</translation>
    </message>
    <message>
        <source>How long the stretch of cut times is that hit</source>
        <translation>Durée de l’intervalle d’instants de coupe qui touchent</translation>
    </message>
    <message>
        <source>When the weight lands</source>
        <translation>Quand la bille arrive au sol</translation>
    </message>
    <message>
        <source>What it hits first, before the floor</source>
        <translation>Ce qu’elle heurte d’abord, avant le sol</translation>
    </message>
    <message>
        <source>Moments that hit</source>
        <translation>Instants qui touchent</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to cut then</source>
        <translation>Double-cliquez sur une ligne, ou appuyez sur Entrée, pour couper à cet instant</translation>
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
        <translation>ligne %1, colonne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>the text ends where a value must stand</source>
        <translation>le texte se termine là où il faut une valeur</translation>
    </message>
    <message>
        <source>a value must stand here</source>
        <translation>il faut une valeur ici</translation>
    </message>
    <message>
        <source>a digit must stand here</source>
        <translation>il faut un chiffre ici</translation>
    </message>
    <message>
        <source>the text ends inside a string</source>
        <translation>le texte se termine dans une chaîne</translation>
    </message>
    <message>
        <source>a control character must be written as an escape</source>
        <translation>un caractère de contrôle doit être écrit avec un échappement</translation>
    </message>
    <message>
        <source>unknown escape in a string</source>
        <translation>échappement inconnu dans une chaîne</translation>
    </message>
    <message>
        <source>half a surrogate pair in a string</source>
        <translation>une moitié de paire de substitution dans une chaîne</translation>
    </message>
    <message>
        <source>four hexadecimal digits must stand here</source>
        <translation>il faut quatre chiffres hexadécimaux ici</translation>
    </message>
    <message>
        <source>nested too deeply</source>
        <translation>trop de niveaux imbriqués</translation>
    </message>
    <message>
        <source>a comma or %1 must stand here</source>
        <translation>il faut une virgule ou %1 ici</translation>
    </message>
    <message>
        <source>a key in quotes must stand here</source>
        <translation>il faut une clé entre guillemets ici</translation>
    </message>
    <message>
        <source>a colon must stand here</source>
        <translation>il faut un deux-points ici</translation>
    </message>
    <message>
        <source>nothing more may stand here</source>
        <translation>il ne faut plus rien ici</translation>
    </message>
</context>
<context>
    <name>ui::KeysPage</name>
    <message>
        <source>%1, previous</source>
        <translation>%1, préc.</translation>
    </message>
    <message>
        <source>In the scene</source>
        <translation>Dans la scène</translation>
    </message>
    <message>
        <source>Wheel, drag</source>
        <translation>Molette, glisser</translation>
    </message>
    <message>
        <source>Zoom, move the view</source>
        <translation>Zoomer, déplacer</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Double clic</translation>
    </message>
    <message>
        <source>Fit the room</source>
        <translation>Cadrer la pièce</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>Select a weight</source>
        <translation>Sélectionner une bille</translation>
    </message>
    <message>
        <source>Drag a weight</source>
        <translation>Glisser une bille</translation>
    </message>
    <message>
        <source>Set its angle or place</source>
        <translation>Angle ou place</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Maj+glisser</translation>
    </message>
    <message>
        <source>Set its rope&apos;s length</source>
        <translation>Longueur de la corde</translation>
    </message>
    <message>
        <source>Drag its arrow</source>
        <translation>Glisser sa flèche</translation>
    </message>
    <message>
        <source>Set its velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Ctrl+glisser</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>Valeurs rondes</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+flèches</translation>
    </message>
    <message>
        <source>Move the weight</source>
        <translation>Déplacer la bille</translation>
    </message>
    <message>
        <source>Alt+Shift+arrows</source>
        <translation>Alt+Maj+flèches</translation>
    </message>
    <message>
        <source>Change its velocity</source>
        <translation>Changer sa vitesse</translation>
    </message>
    <message>
        <source>In the table</source>
        <translation>Dans le tableau</translation>
    </message>
    <message>
        <source>Ins, Del</source>
        <translation>Inser, Suppr</translation>
    </message>
    <message>
        <source>Add, remove weights</source>
        <translation>Ajouter, retirer</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+V</translation>
    </message>
    <message>
        <source>Copy, paste cells</source>
        <translation>Copier, coller</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Remplir vers le bas</translation>
    </message>
    <message>
        <source>In a chart</source>
        <translation>Dans un graphique</translation>
    </message>
    <message>
        <source>Wheel, + −</source>
        <translation>Molette, + −</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoomer</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Glisser</translation>
    </message>
    <message>
        <source>Zoom to a box</source>
        <translation>Zoomer sur un cadre</translation>
    </message>
    <message>
        <source>Shift+drag, Alt+arrows</source>
        <translation>Maj+glisser, Alt+flèches</translation>
    </message>
    <message>
        <source>Move what it shows</source>
        <translation>Déplacer le contenu</translation>
    </message>
    <message>
        <source>Double click, 0</source>
        <translation>Double clic, 0</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Return, Escape</source>
        <translation>Entrée, Échap</translation>
    </message>
    <message>
        <source>Apply, restore a field</source>
        <translation>Valider, rétablir</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Maj+Tab</translation>
    </message>
    <message>
        <source>Next, previous field</source>
        <translation>Champ suivant, préc.</translation>
    </message>
    <message>
        <source>Alt+letter</source>
        <translation>Alt+lettre</translation>
    </message>
    <message>
        <source>Open that menu</source>
        <translation>Ouvrir ce menu</translation>
    </message>
</context>
<context>
    <name>ui::LessonChooser</name>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>Arrow keys and Enter, or a click, open a lesson.</source>
        <translation>Les flèches et Entrée, ou un clic, ouvrent une leçon.</translation>
    </message>
</context>
<context>
    <name>ui::LessonPanel</name>
    <message>
        <source>To try</source>
        <translation>À essayer</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Toutes les leçons</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Fiche</translation>
    </message>
</context>
<context>
    <name>ui::Lessons</name>
    <message>
        <source>One pendulum</source>
        <translation>Un pendule</translation>
    </message>
    <message>
        <source>Watch one weight swing, lose its rope on the way up, fly and bounce: Euler swings higher than it started, RK4 does not.</source>
        <translation>Observez une bille qui se balance, perd sa corde en remontant, vole et rebondit&#xa0;: Euler monte plus haut que le départ, RK4 non.</translation>
    </message>
    <message>
        <source>Press R, then cut the rope yourself with C: when must you cut for the longest throw?</source>
        <translation>Appuyez sur R, puis coupez vous-même la corde avec C&#xa0;: quand faut-il couper pour lancer le plus loin&#xa0;?</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller under Runs: about a tenth of its error is left.</source>
        <translation>Donnez à Euler un pas dix fois plus petit dans Simulations&#xa0;: il reste environ un dixième de son erreur.</translation>
    </message>
    <message>
        <source>Set the air density to 0: does the total still stay flat with both methods?</source>
        <translation>Mettez la masse volumique de l’air à 0&#xa0;: l’énergie totale reste-t-elle constante avec les deux méthodes&#xa0;?</translation>
    </message>
    <message>
        <source>Two weights</source>
        <translation>Deux billes</translation>
    </message>
    <message>
        <source>Watch a small and a large weight of the same lead swing towards each other: when they meet in the air, the light one is thrown back.</source>
        <translation>Observez une petite et une grosse bille du même plomb se balancer l’une vers l’autre&#xa0;: quand elles se heurtent en l’air, la légère est renvoyée.</translation>
    </message>
    <message>
        <source>Press I to go to the impact and read the speeds before and after under Events.</source>
        <translation>Appuyez sur I pour aller au choc et lisez les vitesses avant et après dans Événements.</translation>
    </message>
    <message>
        <source>Give both weights the same mass: who is thrown back now?</source>
        <translation>Donnez la même masse aux deux billes&#xa0;: laquelle est renvoyée maintenant&#xa0;?</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0: how much energy is lost to the impact?</source>
        <translation>Mettez la restitution des billes à 0&#xa0;: combien d’énergie le choc fait-il perdre&#xa0;?</translation>
    </message>
    <message>
        <source>Three pendulums</source>
        <translation>Trois pendules</translation>
    </message>
    <message>
        <source>Watch three ropes of different length start together and fall out of step: the longer the rope, the slower the swing.</source>
        <translation>Observez trois cordes de longueurs différentes partir ensemble puis se déphaser&#xa0;: plus la corde est longue, plus l’oscillation est lente.</translation>
    </message>
    <message>
        <source>Make the first rope 0.3 m long: the third, four times as long, swings half as fast.</source>
        <translation>Donnez 0,3 m à la première corde&#xa0;: la troisième, quatre fois plus longue, oscille deux fois moins vite.</translation>
    </message>
    <message>
        <source>Change the mass of one weight: is its swing slower now?</source>
        <translation>Changez la masse d’une bille&#xa0;: oscille-t-elle maintenant plus lentement&#xa0;?</translation>
    </message>
    <message>
        <source>Press U to go from one turning point to the next and read the times under Events.</source>
        <translation>Appuyez sur U pour passer d’un point de rebroussement au suivant et lisez les instants dans Événements.</translation>
    </message>
    <message>
        <source>Seven weights in a room</source>
        <translation>Sept billes dans une pièce</translation>
    </message>
    <message>
        <source>Watch seven weights swing, all ropes cut at once: they fly, bounce off each other, the walls and the floor, and two methods soon disagree about where.</source>
        <translation>Observez sept billes se balancer, toutes les cordes coupées d’un coup&#xa0;: elles volent, se heurtent, rebondissent sur les murs et le sol, et bientôt deux méthodes ne s’accordent plus sur leurs positions.</translation>
    </message>
    <message>
        <source>Press V to give each method a view of its own.</source>
        <translation>Appuyez sur V pour donner à chaque méthode sa propre vue.</translation>
    </message>
    <message>
        <source>Guess which weight comes to rest first, and look it up under Events.</source>
        <translation>Devinez quelle bille s’immobilise la première, et vérifiez dans Événements.</translation>
    </message>
    <message>
        <source>Halve the step of one method: how much later do the two part?</source>
        <translation>Divisez par deux le pas d’une méthode&#xa0;: combien de temps plus tard les deux se séparent-elles&#xa0;?</translation>
    </message>
    <message>
        <source>Euler gains energy</source>
        <translation>Euler gagne de l’énergie</translation>
    </message>
    <message>
        <source>Watch Euler swing a pendulum higher and higher without a push, until it goes over the top: its energy comes from the method, not from physics.</source>
        <translation>Observez Euler faire monter un pendule de plus en plus haut, sans le pousser, jusqu’à passer par-dessus&#xa0;: cette énergie vient de la méthode, non de la physique.</translation>
    </message>
    <message>
        <source>Give Euler a step ten times smaller: it still gains energy, only more slowly.</source>
        <translation>Donnez à Euler un pas dix fois plus petit&#xa0;: il gagne encore de l’énergie, mais plus lentement.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: all that is hatched was made by the method.</source>
        <translation>Ouvrez le graphique Bilan&#xa0;: tout ce qui est hachuré a été créé par la méthode.</translation>
    </message>
    <message>
        <source>Choose Euler (semi-implicit) for the second run and compare.</source>
        <translation>Choisissez Euler (semi-implicite) pour la deuxième simulation et comparez.</translation>
    </message>
    <message>
        <source>Two kinds of Euler</source>
        <translation>Deux sortes d’Euler</translation>
    </message>
    <message>
        <source>Watch two methods that differ in a single line, whether the new or the old speed moves the weight: one gains energy for ever, the other never strays far.</source>
        <translation>Observez deux méthodes qui ne diffèrent que d’une ligne&#xa0;: est-ce la nouvelle ou l’ancienne vitesse qui déplace la bille&#xa0;? L’une gagne sans cesse de l’énergie, l’autre ne s’égare jamais loin.</translation>
    </message>
    <message>
        <source>Open the Phase chart: one draws a closed loop, the other a spiral.</source>
        <translation>Ouvrez le graphique Phase&#xa0;: l’une dessine une boucle fermée, l’autre une spirale.</translation>
    </message>
    <message>
        <source>Switch on Runge–Kutta 4 as a third run with the same step: what does its energy do?</source>
        <translation>Ajoutez Runge–Kutta 4 comme troisième simulation avec le même pas&#xa0;: que fait son énergie&#xa0;?</translation>
    </message>
    <message>
        <source>Let it play for a minute at speed 8×: is the first run still the same?</source>
        <translation>Laissez tourner une minute à la vitesse 8×&#xa0;: la première simulation est-elle restée la même&#xa0;?</translation>
    </message>
    <message>
        <source>Half the step</source>
        <translation>La moitié du pas</translation>
    </message>
    <message>
        <source>Watch the distance from the first run, which is exact: with half the step Euler errs half as much, and RK4 hardly at all.</source>
        <translation>Observez la distance à la première simulation, qui est exacte&#xa0;: avec un pas deux fois plus petit, Euler se trompe deux fois moins, et RK4 presque plus.</translation>
    </message>
    <message>
        <source>Open Comparison and read the distances after one second and after four.</source>
        <translation>Ouvrez Comparaison et lisez les distances après une seconde et après quatre.</translation>
    </message>
    <message>
        <source>Halve the step of Runge–Kutta 4: its error shrinks to about a sixteenth.</source>
        <translation>Divisez par deux le pas de Runge–Kutta 4&#xa0;: son erreur tombe à environ un seizième.</translation>
    </message>
    <message>
        <source>Open Run ▸ Speed and accuracy to see the same for many steps at once.</source>
        <translation>Ouvrez Simulation ▸ Vitesse et précision pour voir la même chose pour beaucoup de pas à la fois.</translation>
    </message>
    <message>
        <source>Step too large</source>
        <translation>Pas trop grand</translation>
    </message>
    <message>
        <source>Watch the air stop a balloon in three ways: slowly with a small step, dead with a larger one, and never with one that throws it back faster each time.</source>
        <translation>Observez l’air arrêter un ballon de trois façons&#xa0;: lentement avec un petit pas, net avec un plus grand, et jamais avec celui qui le renvoie chaque fois plus vite.</translation>
    </message>
    <message>
        <source>Press R and then → again and again: see how each large step overshoots.</source>
        <translation>Appuyez sur R puis encore et encore sur →&#xa0;: voyez comme chaque grand pas va trop loin.</translation>
    </message>
    <message>
        <source>Open Inside a step for the third run: its one slope points far beyond the other side.</source>
        <translation>Ouvrez Dans un pas pour la troisième simulation&#xa0;: son unique pente pointe loin au-delà de l’autre côté.</translation>
    </message>
    <message>
        <source>Look for the largest step of the third run that does not blow up.</source>
        <translation>Cherchez le plus grand pas de la troisième simulation qui n’explose pas.</translation>
    </message>
    <message>
        <source>Small and large swings</source>
        <translation>Petites et grandes oscillations</translation>
    </message>
    <message>
        <source>Watch four pendulums of the same length start together: only small swings keep the same time, and the wider one swings, the longer it takes.</source>
        <translation>Observez quatre pendules de même longueur partir ensemble&#xa0;: seules les petites oscillations gardent la même période, et plus l’amplitude est grande, plus elle est longue.</translation>
    </message>
    <message>
        <source>Press U to find the first turning points and compare the times.</source>
        <translation>Appuyez sur U pour trouver les premiers points de rebroussement et comparez les instants.</translation>
    </message>
    <message>
        <source>Set the start angles to 5°, 10°, 15° and 20°: now they keep step for a long time.</source>
        <translation>Mettez les angles initiaux à 5°, 10°, 15° et 20°&#xa0;: ils restent maintenant longtemps en phase.</translation>
    </message>
    <message>
        <source>Set one start angle to 179.9°: how long does it stay near the top?</source>
        <translation>Mettez un angle initial à 179,9°&#xa0;: combien de temps la bille reste-t-elle près du sommet&#xa0;?</translation>
    </message>
    <message>
        <source>Slack rope</source>
        <translation>Corde détendue</translation>
    </message>
    <message>
        <source>Watch a rod and a rope with the same push: the rod carries its weight over the top, the rope goes slack on the way up and jerks tight on the way down.</source>
        <translation>Observez une tige et une corde lancées de la même façon&#xa0;: la tige fait passer sa bille par le sommet, la corde se détend en montant et se retend d’un coup en descendant.</translation>
    </message>
    <message>
        <source>Switch to speed 1/8× at the moment the rope goes slack: the weight flies as if thrown.</source>
        <translation>Passez à la vitesse 1/8× au moment où la corde se détend&#xa0;: la bille vole comme si on l’avait lancée.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: how much energy does the jerk cost?</source>
        <translation>Ouvrez le graphique Bilan&#xa0;: combien d’énergie la secousse coûte-t-elle&#xa0;?</translation>
    </message>
    <message>
        <source>Change gravity until the rope stays taut all the way round.</source>
        <translation>Changez la pesanteur jusqu’à ce que la corde reste tendue sur tout le tour.</translation>
    </message>
    <message>
        <source>A throw with and without air</source>
        <translation>Un lancer avec et sans air</translation>
    </message>
    <message>
        <source>Watch two equal throws, one through air and one that the air does not touch: with air the path is shorter, lower and steeper at its end.</source>
        <translation>Observez deux lancers égaux, l’un dans l’air, l’autre que l’air ne freine pas&#xa0;: avec l’air, la trajectoire est plus courte, plus basse et plus raide à la fin.</translation>
    </message>
    <message>
        <source>Open the Paths chart: which of the two paths is a parabola?</source>
        <translation>Ouvrez le graphique Trajectoires&#xa0;: laquelle des deux est une parabole&#xa0;?</translation>
    </message>
    <message>
        <source>Make the first ball ten times as heavy: how much further does it get?</source>
        <translation>Rendez la première balle dix fois plus lourde&#xa0;: va-t-elle beaucoup plus loin&#xa0;?</translation>
    </message>
    <message>
        <source>Set the air density to 0: now both paths have the same shape.</source>
        <translation>Mettez la masse volumique de l’air à 0&#xa0;: les deux trajectoires ont maintenant la même forme.</translation>
    </message>
    <message>
        <source>Terminal velocity</source>
        <translation>Vitesse limite</translation>
    </message>
    <message>
        <source>Watch three balls of one size fall: the light ones soon fall at a constant speed, where the drag of the air is as large as their weight.</source>
        <translation>Observez tomber trois balles de même taille&#xa0;: les légères tombent bientôt à vitesse constante, celle où la résistance de l’air égale leur poids.</translation>
    </message>
    <message>
        <source>Open the Speed chart: whose curve becomes level, and how soon?</source>
        <translation>Ouvrez le graphique Vitesse&#xa0;: quelle courbe devient horizontale, et au bout de combien de temps&#xa0;?</translation>
    </message>
    <message>
        <source>Read off both level speeds: the second ball is four times as heavy as the first.</source>
        <translation>Lisez les deux vitesses constantes&#xa0;: la deuxième balle est quatre fois plus lourde que la première.</translation>
    </message>
    <message>
        <source>Set the air density to 0: all three hit the floor together.</source>
        <translation>Mettez la masse volumique de l’air à 0&#xa0;: les trois touchent le sol ensemble.</translation>
    </message>
    <message>
        <source>Infinitely many bounces</source>
        <translation>Une infinité de rebonds</translation>
    </message>
    <message>
        <source>Watch a ball that loses a fifth of its speed at every bounce: it bounces infinitely often, and yet all bounces are over within six seconds.</source>
        <translation>Observez une balle qui perd un cinquième de sa vitesse à chaque rebond&#xa0;: elle rebondit une infinité de fois, et pourtant tous les rebonds sont finis en moins de six secondes.</translation>
    </message>
    <message>
        <source>Open the Height chart and zoom in on the end: it looks the same again and again.</source>
        <translation>Ouvrez le graphique Hauteur et zoomez sur la fin&#xa0;: c’est toujours la même image.</translation>
    </message>
    <message>
        <source>Go to the last impacts with I: the times between them form a geometric series.</source>
        <translation>Allez aux derniers chocs avec I&#xa0;: les durées qui les séparent forment une suite géométrique.</translation>
    </message>
    <message>
        <source>Set the restitution of walls to 0.9: the bounces now last about twice as long.</source>
        <translation>Mettez la restitution des parois à 0,9&#xa0;: les rebonds durent maintenant environ deux fois plus longtemps.</translation>
    </message>
    <message>
        <source>Newton&apos;s cradle</source>
        <translation>Pendule de Newton</translation>
    </message>
    <message>
        <source>Watch one weight knock against four that hang at rest: only the last one flies off, because energy and momentum must both be kept.</source>
        <translation>Observez une bille en heurter quatre qui pendent au repos&#xa0;: seule la dernière part, car l’énergie et la quantité de mouvement doivent toutes deux se conserver.</translation>
    </message>
    <message>
        <source>Pull two weights aside: give weight 2 the start angle −40°, too. How many fly off?</source>
        <translation>Écartez deux billes&#xa0;: donnez aussi à la bille 2 l’angle initial −40°. Combien partent&#xa0;?</translation>
    </message>
    <message>
        <source>Play the impacts at speed 1/64×: the push passes through four weights in no time.</source>
        <translation>Passez les chocs à la vitesse 1/64×&#xa0;: l’impulsion traverse quatre billes en un instant.</translation>
    </message>
    <message>
        <source>Set the restitution of weights to 0.5: after a while all swing together.</source>
        <translation>Mettez la restitution des billes à 0,5&#xa0;: au bout d’un moment, toutes se balancent ensemble.</translation>
    </message>
    <message>
        <source>Counting π by impacts</source>
        <translation>Compter π par des chocs</translation>
    </message>
    <message>
        <source>Watch a disc a hundred times as heavy drive a light one against the wall: there are 31 impacts before they part, the first digits of π.</source>
        <translation>Observez un disque cent fois plus lourd pousser un disque léger contre le mur&#xa0;: il y a 31 chocs avant qu’ils se séparent, les premiers chiffres de π.</translation>
    </message>
    <message>
        <source>Open Events and choose Impacts: count them until the heavy disc hits the right wall.</source>
        <translation>Ouvrez Événements et choisissez Chocs&#xa0;: comptez-les jusqu’à ce que le disque lourd touche le mur droit.</translation>
    </message>
    <message>
        <source>Make the heavy disc 1000 kg, 10⁴ times the light one: there are 314 impacts.</source>
        <translation>Donnez 1000 kg au disque lourd, 10⁴ fois le léger&#xa0;: il y a 314 chocs.</translation>
    </message>
    <message>
        <source>Give the run a step ten times as large: the number stays the same. Why?</source>
        <translation>Donnez à la simulation un pas dix fois plus grand&#xa0;: le nombre reste le même. Pourquoi&#xa0;?</translation>
    </message>
    <message>
        <source>A thousand pendulums</source>
        <translation>Mille pendules</translation>
    </message>
    <message>
        <source>Watch a thousand pendulums start as one straight line, each a hair longer than the next: the line bends, winds up and falls apart into dust.</source>
        <translation>Observez mille pendules partir en une seule ligne droite, chacun plus long que son voisin d’un cheveu&#xa0;: la ligne se courbe, s’enroule et tombe en poussière.</translation>
    </message>
    <message>
        <source>Stop after 5 s and after 20 s: are weights that started side by side still neighbours?</source>
        <translation>Arrêtez après 5 s et après 20 s&#xa0;: les billes parties côte à côte sont-elles encore voisines&#xa0;?</translation>
    </message>
    <message>
        <source>Set all start angles to 170°: does the line fall apart sooner?</source>
        <translation>Mettez tous les angles initiaux à 170°&#xa0;: la ligne se défait-elle plus tôt&#xa0;?</translation>
    </message>
    <message>
        <source>Press C while they swing: a thousand weights fly off along a thousand paths.</source>
        <translation>Appuyez sur C pendant qu’ils se balancent&#xa0;: mille billes s’envolent sur mille trajectoires.</translation>
    </message>
    <message>
        <source>A pile comes to rest</source>
        <translation>Un tas s’immobilise</translation>
    </message>
    <message>
        <source>Watch balls rain into a box and settle: every impact takes some energy, until all lie still and no ball overlaps another.</source>
        <translation>Observez des balles pleuvoir dans une boîte et se tasser&#xa0;: chaque choc prend de l’énergie, jusqu’à ce que toutes soient au repos sans qu’aucune n’en recouvre une autre.</translation>
    </message>
    <message>
        <source>Open the Ledger chart: where has all the energy gone?</source>
        <translation>Ouvrez le graphique Bilan&#xa0;: où est passée toute l’énergie&#xa0;?</translation>
    </message>
    <message>
        <source>Set both restitutions to 0.8: how much longer does it take until all lie still?</source>
        <translation>Mettez les deux restitutions à 0,8&#xa0;: combien de temps de plus faut-il pour que tout soit au repos&#xa0;?</translation>
    </message>
    <message>
        <source>Make the room twice as wide: how high is the pile now?</source>
        <translation>Rendez la pièce deux fois plus large&#xa0;: quelle est maintenant la hauteur du tas&#xa0;?</translation>
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
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Built-in scenes</source>
        <translation>Scènes &amp;fournies</translation>
    </message>
    <message>
        <source>Export energy &amp;ledger</source>
        <translation>Exporter le &amp;bilan d’énergie</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Aller à</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>&amp;Bille</translation>
    </message>
    <message>
        <source>&amp;Chart</source>
        <translation>&amp;Graphique</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Which of the panels that share this place is shown</source>
        <translation>Lequel des panneaux qui partagent cette place est montré</translation>
    </message>
</context>
<context>
    <name>ui::MeasurementTable</name>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dérive</translation>
    </message>
    <message>
        <source>Time/s</source>
        <translation>Calcul/s</translation>
    </message>
    <message>
        <source>Slopes</source>
        <translation>Pentes</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Issue</translation>
    </message>
    <message>
        <source>Step, or tolerance of an adaptive method</source>
        <translation>Pas, ou tolérance d’une méthode adaptative</translation>
    </message>
    <message>
        <source>Largest distance of any weight from where it really is</source>
        <translation>Plus grande distance d’une bille à sa vraie position</translation>
    </message>
    <message>
        <source>Largest numerical drift of the energy</source>
        <translation>Plus grande dérive numérique de l’énergie</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Temps de calcul par seconde simulée</translation>
    </message>
    <message>
        <source>Slope evaluations</source>
        <translation>Évaluations de pente</translation>
    </message>
    <message>
        <source>Whether the run came to the end</source>
        <translation>Si la simulation est arrivée au bout</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Points mesurés</translation>
    </message>
    <message>
        <source>Double-click a row, or press Return, to open it as a run</source>
        <translation>Double-cliquez sur une ligne, ou appuyez sur Entrée, pour l’ouvrir comme simulation</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>diverged at %1 s</source>
        <translation>diverge à %1 s</translation>
    </message>
</context>
<context>
    <name>ui::OpenAsRun</name>
    <message>
        <source>addition of a run</source>
        <translation>ajout d’une simulation</translation>
    </message>
</context>
<context>
    <name>ui::PanelTitle</name>
    <message>
        <source>Take the panel out of the window, or put it back</source>
        <translation>Détacher le panneau de la fenêtre, ou l’y remettre</translation>
    </message>
    <message>
        <source>Close the panel; the view menu brings it back</source>
        <translation>Fermer le panneau&#xa0;; le menu Affichage le rouvre</translation>
    </message>
</context>
<context>
    <name>ui::PlaybackBar</name>
    <message>
        <source>%1× real time</source>
        <translation>%1× temps réel</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Speed (, and .)</source>
        <translation>Vitesse (, et .)</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Temps simulé</translation>
    </message>
    <message>
        <source>Whether the computer keeps up with the chosen speed</source>
        <translation>Si l’ordinateur suit la vitesse choisie</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>in real time</source>
        <translation>en temps réel</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <translation>Vitesse %1</translation>
    </message>
    <message>
        <source>Simulated seconds in a second of real time</source>
        <translation>Secondes simulées en une seconde réelle</translation>
    </message>
    <message>
        <source>Simulated time t, in s: the moment that all views show</source>
        <translation>Temps simulé t, en s&#xa0;: l’instant que montrent toutes les vues</translation>
    </message>
</context>
<context>
    <name>ui::PresentationHeader</name>
    <message>
        <source>Simulated time</source>
        <translation>Temps simulé</translation>
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
        <translation>attendu&#xa0;: au moins %1&#xa0;; lu&#xa0;: %2</translation>
    </message>
    <message>
        <source>must be from %1 to %2, got %3</source>
        <translation>attendu&#xa0;: de %1 à %2&#xa0;; lu&#xa0;: %3</translation>
    </message>
    <message>
        <source>must be inside the room, got %1</source>
        <translation>attendu&#xa0;: un point dans la pièce&#xa0;; lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>must put the whole weight, of radius %1 m, inside the room, got %2</source>
        <translation>attendu&#xa0;: la bille entière, de rayon %1 m, dans la pièce&#xa0;; lu&#xa0;: %2</translation>
    </message>
    <message>
        <source>must not overlap %1 at the start</source>
        <translation>ne doit pas recouvrir %1 au départ</translation>
    </message>
    <message>
        <source>must be at most %1, got %2</source>
        <translation>attendu&#xa0;: au plus %1&#xa0;; lu&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ui::ProblemWords</name>
    <message>
        <source>Gravity</source>
        <translation>La pesanteur</translation>
    </message>
    <message>
        <source>The air density</source>
        <translation>La masse volumique de l’air</translation>
    </message>
    <message>
        <source>The room&apos;s width</source>
        <translation>La largeur de la pièce</translation>
    </message>
    <message>
        <source>The room&apos;s height</source>
        <translation>La hauteur de la pièce</translation>
    </message>
    <message>
        <source>The room&apos;s restitution</source>
        <translation>La restitution des parois</translation>
    </message>
    <message>
        <source>The friction</source>
        <translation>Le frottement</translation>
    </message>
    <message>
        <source>The weights&apos; restitution</source>
        <translation>La restitution des billes</translation>
    </message>
    <message>
        <source>The time of the cut</source>
        <translation>L’instant de la coupe</translation>
    </message>
    <message>
        <source>The mass</source>
        <translation>La masse</translation>
    </message>
    <message>
        <source>The radius</source>
        <translation>Le rayon</translation>
    </message>
    <message>
        <source>The drag coefficient</source>
        <translation>Le coefficient de traînée</translation>
    </message>
    <message>
        <source>The rope&apos;s length</source>
        <translation>La longueur de la corde</translation>
    </message>
    <message>
        <source>The start angle</source>
        <translation>L’angle initial</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Le pas</translation>
    </message>
    <message>
        <source>The rope of weight %1 is tied outside the room.</source>
        <translation>La corde de la bille %1 est attachée hors de la pièce.</translation>
    </message>
    <message>
        <source>Weight %1 does not start inside the room.</source>
        <translation>La bille %1 ne part pas de l’intérieur de la pièce.</translation>
    </message>
    <message>
        <source>%1 must be %2.</source>
        <translation>%1 doit valoir %2.</translation>
    </message>
    <message>
        <source>%1 (number %2) must be %3.</source>
        <translation>%1 (n° %2) doit valoir %3.</translation>
    </message>
    <message>
        <source>Weights %1 and %2 overlap at the start.</source>
        <translation>Les billes %1 et %2 se recouvrent au départ.</translation>
    </message>
    <message numerus="yes">
        <source>(and %n more problem(s))</source>
        <translation>
            <numerusform>(et %n autre problème)</numerusform>
            <numerusform>(et %n autres problèmes)</numerusform>
        </translation>
    </message>
    <message>
        <source>The angular velocity</source>
        <translation>La vitesse angulaire</translation>
    </message>
    <message>
        <source>The velocity x</source>
        <translation>La vitesse x</translation>
    </message>
    <message>
        <source>The velocity y</source>
        <translation>La vitesse y</translation>
    </message>
    <message>
        <source>The tolerance</source>
        <translation>La tolérance</translation>
    </message>
    <message>
        <source>There are more than %1 runs.</source>
        <translation>Il y a plus de %1 simulations.</translation>
    </message>
    <message>
        <source>There are more than %1 weights.</source>
        <translation>Il y a plus de %1 billes.</translation>
    </message>
</context>
<context>
    <name>ui::QuantityField</name>
    <message>
        <source>Must be %1</source>
        <translation>Doit valoir %1</translation>
    </message>
</context>
<context>
    <name>ui::QuantitySpinBox</name>
    <message>
        <source>several</source>
        <translation>plusieurs</translation>
    </message>
</context>
<context>
    <name>ui::Range</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 ou plus</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>de %1 à %2</translation>
    </message>
</context>
<context>
    <name>ui::RecentFiles</name>
    <message>
        <source>%1 (gone)</source>
        <translation>%1 (disparu)</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>&amp;Effacer cette liste</translation>
    </message>
    <message>
        <source>The file is no longer there. It is taken off the list.</source>
        <translation>Le fichier n’est plus là. Il est retiré de la liste.</translation>
    </message>
</context>
<context>
    <name>ui::Recovery</name>
    <message>
        <source>The program ended before changes of %1 were saved, on %2.</source>
        <translation>Le programme s’est arrêté avant que les changements de %1 ne soient enregistrés, le %2.</translation>
    </message>
    <message>
        <source>a new scene</source>
        <translation>une nouvelle scène</translation>
    </message>
    <message>
        <source>recovery of changes</source>
        <translation>récupération de changements</translation>
    </message>
</context>
<context>
    <name>ui::RunWords</name>
    <message>
        <source>Euler (explicit)</source>
        <translation>Euler (explicite)</translation>
    </message>
    <message>
        <source>Euler (semi-implicit)</source>
        <translation>Euler (semi-implicite)</translation>
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
        <translation>Référence</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, tolérance %2</translation>
    </message>
    <message>
        <source>%1, %2 s</source>
        <translation>%1, %2 s</translation>
    </message>
    <message>
        <source>%1, diverged at %2 s. Its last finite state is shown; try a smaller step.</source>
        <translation>%1, diverge à %2 s. Son dernier état fini est montré&#xa0;; essayez un pas plus petit.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: one step held more impacts than a step may.</source>
        <translation>%1, arrêt à %2 s&#xa0;: un pas contenait plus de chocs qu’un pas n’en permet.</translation>
    </message>
    <message>
        <source>%1, stopped at %2 s: the tolerance asks for more or smaller steps than can be taken.</source>
        <translation>%1, arrêt à %2 s&#xa0;: la tolérance demande des pas plus nombreux ou plus petits que possible.</translation>
    </message>
</context>
<context>
    <name>ui::RunsForm</name>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Step, tolerance</source>
        <translation>Pas, tolérance</translation>
    </message>
    <message>
        <source>Step of run %1</source>
        <translation>Pas de la simulation %1</translation>
    </message>
    <message>
        <source>Tolerance of run %1</source>
        <translation>Tolérance de la simulation %1</translation>
    </message>
    <message>
        <source>Method of run %1</source>
        <translation>Méthode de la simulation %1</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Simulation %1</translation>
    </message>
    <message>
        <source>addition of a run</source>
        <translation>ajout d’une simulation</translation>
    </message>
    <message>
        <source>removal of a run</source>
        <translation>retrait d’une simulation</translation>
    </message>
    <message>
        <source>change of the method</source>
        <translation>changement de méthode</translation>
    </message>
    <message>
        <source>How the run gets from one moment to the next. The error of a method of order p shrinks with the step h like h to the power of p.</source>
        <translation>Comment la simulation passe d’un instant au suivant. L’erreur d’une méthode d’ordre p diminue avec le pas h comme h puissance p.</translation>
    </message>
    <message>
        <source>Step h in s: how much simulated time the method takes at once. Smaller steps are more exact and cost more.</source>
        <translation>Pas h en s&#xa0;: le temps simulé que la méthode franchit d’un coup. Un pas plus petit est plus exact et coûte plus cher.</translation>
    </message>
    <message>
        <source>Tolerance, without unit: the error the method allows itself in a step, in m, m/s, rad and rad/s. It chooses its steps accordingly.</source>
        <translation>Tolérance, sans unité&#xa0;: l’erreur que la méthode se permet dans un pas, en m, m/s, rad et rad/s. Elle choisit ses pas en conséquence.</translation>
    </message>
    <message>
        <source>Compute the scene with this method, too</source>
        <translation>Calculer la scène avec cette méthode aussi</translation>
    </message>
</context>
<context>
    <name>ui::SceneAnnouncer</name>
    <message>
        <source>No weight selected</source>
        <translation>Aucune bille sélectionnée</translation>
    </message>
    <message>
        <source>Weight %1 selected</source>
        <translation>Bille %1 sélectionnée</translation>
    </message>
    <message>
        <source>%1: weight %2, at %3 s</source>
        <comment>an event, such as: Impact on the floor</comment>
        <translation>%1&#xa0;: bille %2, à %3 s</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>an event and how many there are</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ui::SceneCommands</name>
    <message>
        <source>Weights can be moved at the start: press Home, or R for a reset</source>
        <translation>Les billes ne se déplacent qu’au départ&#xa0;: appuyez sur Début, ou sur R pour recommencer</translation>
    </message>
</context>
<context>
    <name>ui::SceneDrop</name>
    <message>
        <source>What was dropped</source>
        <translation>Ce qui a été déposé</translation>
    </message>
    <message>
        <source>These are %1 files. Drop one scene file.</source>
        <translation>Ce sont %1 fichiers. Déposez un seul fichier de scène.</translation>
    </message>
    <message>
        <source>It is no file on this computer.</source>
        <translation>Ce n’est pas un fichier de cet ordinateur.</translation>
    </message>
    <message>
        <source>It is a folder. Drop a scene file.</source>
        <translation>C’est un dossier. Déposez un fichier de scène.</translation>
    </message>
</context>
<context>
    <name>ui::SceneFile</name>
    <message>
        <source>not UTF-8</source>
        <translation>pas en UTF-8</translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>pas du JSON&#xa0;: %1</translation>
    </message>
    <message>
        <source>larger than 64 MiB</source>
        <translation>plus de 64 MiB</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>not UTF-8 but UTF-16; save it as UTF-8</source>
        <translation>en UTF-16 et non en UTF-8&#xa0;; enregistrez-le en UTF-8</translation>
    </message>
    <message>
        <source>it is no file but a pipe or a device</source>
        <translation>ce n’est pas un fichier mais un tube ou un périphérique</translation>
    </message>
</context>
<context>
    <name>ui::SceneFiles</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>The scene has changes that are not saved. Save them?</source>
        <translation>La scène a des changements non enregistrés. Les enregistrer&#xa0;?</translation>
    </message>
    <message>
        <source>What could not be applied is not saved: %1</source>
        <translation>Ce qui n’a pu être appliqué n’est pas enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>start of a new scene</source>
        <translation>nouvelle scène</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Ouvrir une scène</translation>
    </message>
    <message>
        <source>Scenes (*.json);;All files (*)</source>
        <translation>Scènes (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Scene not opened</source>
        <translation>Scène non ouverte</translation>
    </message>
    <message>
        <source>%1 was not opened:
%2</source>
        <translation>%1 n’a pas été ouvert&#xa0;:
%2</translation>
    </message>
    <message>
        <source>opening of %1</source>
        <translation>ouverture de %1</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Enregistrer la scène</translation>
    </message>
    <message>
        <source>Scene (*%1 *.json)</source>
        <translation>Scène (*%1 *.json)</translation>
    </message>
    <message>
        <source>Scene not saved</source>
        <translation>Scène non enregistrée</translation>
    </message>
    <message>
        <source>%1 was not saved:
%2</source>
        <translation>%1 n’a pas été enregistré&#xa0;:
%2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
</context>
<context>
    <name>ui::SceneForm</name>
    <message>
        <source>Cut at</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Billes</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Pesanteur</translation>
    </message>
    <message>
        <source>Air density</source>
        <translation>Masse volumique de l’air</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Chocs</translation>
    </message>
    <message>
        <source>Restitution of walls</source>
        <translation>Restitution des parois</translation>
    </message>
    <message>
        <source>Friction of walls</source>
        <translation>Frottement des parois</translation>
    </message>
    <message>
        <source>Restitution of weights</source>
        <translation>Restitution des billes</translation>
    </message>
    <message>
        <source>Unticked: all ropes are cut by hand, with the Cut button</source>
        <translation>Décoché&#xa0;: toutes les cordes sont coupées à la main, avec le bouton Couper</translation>
    </message>
    <message>
        <source>Time of the cut</source>
        <translation>Instant de la coupe</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>change of the cut</source>
        <translation>changement de la coupe</translation>
    </message>
    <message>
        <source>How many weights there are, hung up at even intervals. New ones are like the last one.</source>
        <translation>Nombre de billes, accrochées à intervalles réguliers. Les nouvelles sont comme la dernière.</translation>
    </message>
    <message>
        <source>Acceleration of free fall g, in m/s². It pulls each weight down with the force m g. On Earth 9.81 m/s².</source>
        <translation>Accélération de la chute libre g, en m/s². Elle tire chaque bille vers le bas avec la force m g. Sur Terre 9,81 m/s².</translation>
    </message>
    <message>
        <source>Density of the air ρ, in kg/m³. Drag is F = ½ ρ c_d A v² against the velocity, with A = π r². 1.2 kg/m³ at sea level, 0 for vacuum.</source>
        <translation>Masse volumique de l’air ρ, en kg/m³. La traînée est F = ½ ρ c_d A v², opposée à la vitesse, avec A = π r². 1,2 kg/m³ au niveau de la mer, 0 pour le vide.</translation>
    </message>
    <message>
        <source>Distance between the walls, in m.</source>
        <translation>Distance entre les murs, en m.</translation>
    </message>
    <message>
        <source>Distance between floor and ceiling, in m.</source>
        <translation>Distance entre le sol et le plafond, en m.</translation>
    </message>
    <message>
        <source>Share e of the speed towards a wall, the floor or the ceiling with which a weight leaves it: 1 loses nothing, 0 does not bounce.</source>
        <translation>Part e de la vitesse vers un mur, le sol ou le plafond avec laquelle une bille en repart&#xa0;: 1 ne perd rien, 0 ne rebondit pas.</translation>
    </message>
    <message>
        <source>Friction coefficient μ of walls, floor and ceiling. Friction is at most μ times the force, or the impulse, that presses the weight against them.</source>
        <translation>Coefficient de frottement μ des murs, du sol et du plafond. Le frottement vaut au plus μ fois la force, ou l’impulsion, qui presse la bille contre eux.</translation>
    </message>
    <message>
        <source>Share e of the speed towards each other with which two weights part after an impact: 1 loses nothing, 0 does not bounce.</source>
        <translation>Part e de la vitesse de rapprochement avec laquelle deux billes se séparent après un choc&#xa0;: 1 ne perd rien, 0 ne rebondit pas.</translation>
    </message>
    <message>
        <source>Simulated time in s at which all ropes are cut.</source>
        <translation>Temps simulé en s auquel toutes les cordes sont coupées.</translation>
    </message>
</context>
<context>
    <name>ui::SceneLoading</name>
    <message>
        <source>Opening %1…</source>
        <translation>Ouverture de %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ui::SceneMarker</name>
    <message>
        <source>Weight %1</source>
        <translation>Bille %1</translation>
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
        <translation>Scène</translation>
    </message>
    <message>
        <source>a picture&apos;s name must end in .png, .svg or .pdf</source>
        <translation>le nom d’une image doit se terminer par .png, .svg ou .pdf</translation>
    </message>
</context>
<context>
    <name>ui::SceneReader</name>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>attendu&#xa0;: %1&#xa0;; lu&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads version %2</source>
        <translation>%1 est plus récent que ce programme, qui lit la version %2</translation>
    </message>
    <message>
        <source>must have either rope or position, got both</source>
        <translation>il faut soit rope, soit position, pas les deux</translation>
    </message>
    <message>
        <source>must have either rope or position, got neither</source>
        <translation>il faut soit rope, soit position&#xa0;: les deux manquent</translation>
    </message>
    <message>
        <source>velocity goes with position, got it with rope</source>
        <translation>velocity va avec position, non avec rope</translation>
    </message>
    <message>
        <source>%1 takes a tolerance, not a step</source>
        <translation>%1 se règle par une tolérance, non par un pas</translation>
    </message>
    <message>
        <source>%1 takes a step, not a tolerance</source>
        <translation>%1 se règle par un pas, non par une tolérance</translation>
    </message>
    <message>
        <source>must be like &quot;#e69f00&quot;, got %1</source>
        <translation>attendu&#xa0;: de la forme &quot;#e69f00&quot;&#xa0;; lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>there is no method named %1</source>
        <translation>il n’y a pas de méthode nommée %1</translation>
    </message>
</context>
<context>
    <name>ui::SceneToolbar</name>
    <message>
        <source>Scene tools</source>
        <translation>Outils de la scène</translation>
    </message>
</context>
<context>
    <name>ui::SceneView</name>
    <message>
        <source>at the selected weight only</source>
        <translation>pour la bille sélectionnée seulement</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>poids</translation>
    </message>
    <message>
        <source>air</source>
        <translation>air</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>corde</translation>
    </message>
    <message>
        <source>weights enlarged</source>
        <translation>billes agrandies</translation>
    </message>
    <message>
        <source>Δx %1, Δy %2</source>
        <translation>Δx %1, Δy %2</translation>
    </message>
    <message>
        <source>Trails shortened: many weights</source>
        <translation>Traces raccourcies&#xa0;: beaucoup de billes</translation>
    </message>
    <message>
        <source>No trails: too many weights</source>
        <translation>Pas de traces&#xa0;: trop de billes</translation>
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
        <translation>QPainter (OpenGL perdu)</translation>
    </message>
    <message>
        <source>QPainter (no OpenGL 3.3)</source>
        <translation>QPainter (pas d’OpenGL 3.3)</translation>
    </message>
    <message>
        <source>QPainter (software OpenGL would be slower)</source>
        <translation>QPainter (OpenGL logiciel serait plus lent)</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>step × %1</source>
        <translation>pas × %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>stopwatch runs</source>
        <translation>chronomètre en marche</translation>
    </message>
    <message>
        <source>stopwatch stands</source>
        <translation>chronomètre arrêté</translation>
    </message>
    <message>
        <source>Hit at %1 s</source>
        <translation>Touchée à %1 s</translation>
    </message>
    <message>
        <source>Missed by %1 m at %2 s</source>
        <translation>Manquée de %1 m à %2 s</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>The room with its weights and ropes. A click selects a weight, the wheel zooms, dragging moves the view.</source>
        <translation>La pièce avec ses billes et ses cordes. Un clic sélectionne une bille, la molette zoome, glisser déplace la vue.</translation>
    </message>
</context>
<context>
    <name>ui::SeparationChart</name>
    <message>
        <source>Distance between the runs over time</source>
        <translation>Distance entre les simulations au cours du temps</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Largest distance between the same weight in both runs, in m, on a logarithmic axis</source>
        <translation>Plus grande distance entre la même bille des deux simulations, en m, sur un axe logarithmique</translation>
    </message>
</context>
<context>
    <name>ui::Settings</name>
    <message>
        <source>The settings in %1 were damaged; what could not be read is as at first.</source>
        <translation>Les réglages dans %1 étaient abîmés&#xa0;; ce qui était illisible est comme au départ.</translation>
    </message>
    <message>
        <source>Settings are not remembered: nothing can be written to %1</source>
        <translation>Les réglages ne sont pas gardés&#xa0;: impossible d’écrire dans %1</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPanel</name>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Stability map</source>
        <translation>Carte de stabilité</translation>
    </message>
    <message>
        <source>Method of the map</source>
        <translation>Méthode de la carte</translation>
    </message>
    <message>
        <source>What the map changes besides the step</source>
        <translation>Ce que la carte fait varier outre le pas</translation>
    </message>
    <message>
        <source>Simulated time of each run</source>
        <translation>Temps simulé de chaque simulation</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Step ×</source>
        <translation>Pas ×</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Temps simulé</translation>
    </message>
    <message>
        <source>rope length</source>
        <translation>longueur de corde</translation>
    </message>
    <message>
        <source>air density</source>
        <translation>masse volumique de l’air</translation>
    </message>
    <message>
        <source>Finds the largest step at which each method stays bounded, that is, makes less energy out of nothing than the scene has to move with.</source>
        <translation>Cherche le plus grand pas avec lequel chaque méthode reste bornée, c’est-à-dire crée moins d’énergie à partir de rien que la scène n’en a pour se mouvoir.</translation>
    </message>
    <message>
        <source>stability</source>
        <translation>stabilite</translation>
    </message>
    <message>
        <source>Export stability map</source>
        <translation>Exporter la carte de stabilité</translation>
    </message>
    <message>
        <source>For which steps the run keeps its energy, and for which it grows beyond all bounds</source>
        <translation>Pour quels pas la simulation garde son énergie, et pour lesquels elle croît sans limite</translation>
    </message>
    <message>
        <source>How long each run is followed, in s: what grows slowly needs time to show</source>
        <translation>Durée pendant laquelle chaque simulation est suivie, en s&#xa0;: ce qui croît lentement demande du temps pour se voir</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>Enregistrer la carte en image</translation>
    </message>
</context>
<context>
    <name>ui::StabilityPlot</name>
    <message>
        <source>drift under 1 %</source>
        <translation>dérive sous 1 %</translation>
    </message>
    <message>
        <source>under 10 %</source>
        <translation>sous 10 %</translation>
    </message>
    <message>
        <source>up to 100 %</source>
        <translation>jusqu’à 100 %</translation>
    </message>
    <message>
        <source>energy more than doubled</source>
        <translation>énergie plus que doublée</translation>
    </message>
    <message>
        <source>diverged</source>
        <translation>diverge</translation>
    </message>
    <message>
        <source>%1, each run over %2 s. Drift as a share of the energy the scene has to move with; empty: the weights do not fit the room.</source>
        <translation>%1, chaque simulation sur %2 s. Dérive en part de l’énergie disponible&#xa0;; vide&#xa0;: les billes ne tiennent pas dans la pièce.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Length of the longest rope</source>
        <translation>Longueur de la plus longue corde</translation>
    </message>
    <message>
        <source>Air density (kg/m³)</source>
        <translation>Masse volumique de l’air (kg/m³)</translation>
    </message>
</context>
<context>
    <name>ui::StepPanel</name>
    <message>
        <source>of weight</source>
        <translation>de la bille</translation>
    </message>
    <message>
        <source>Weight whose step is shown</source>
        <translation>Bille dont le pas est montré</translation>
    </message>
    <message>
        <source>Which weight, counted from the left</source>
        <translation>Quelle bille, comptée depuis la gauche</translation>
    </message>
    <message>
        <source>Run whose step is shown</source>
        <translation>Simulation dont le pas est montré</translation>
    </message>
    <message>
        <source>Part of the step</source>
        <translation>Partie du pas</translation>
    </message>
    <message>
        <source>Events divide a step: the method starts anew after each</source>
        <translation>Les événements divisent un pas&#xa0;: la méthode repart après chacun</translation>
    </message>
    <message>
        <source>The coming step takes long to compute: go on to see it.</source>
        <translation>Le pas à venir est long à calculer&#xa0;: avancez pour le voir.</translation>
    </message>
    <message>
        <source>Part %1 of %2</source>
        <translation>Partie %1 sur %2</translation>
    </message>
    <message>
        <source>There is no step to show.</source>
        <translation>Il n’y a pas de pas à montrer.</translation>
    </message>
    <message>
        <source>The reference takes no slopes: choose another run.</source>
        <translation>La référence n’évalue pas de pentes&#xa0;: choisissez une autre simulation.</translation>
    </message>
    <message>
        <source>Nothing moves the weight in this step.</source>
        <translation>Rien ne déplace la bille pendant ce pas.</translation>
    </message>
    <message>
        <source>to come, from %1 s to %2 s</source>
        <translation>à venir, de %1 s à %2 s</translation>
    </message>
    <message>
        <source>from %1 s to %2 s</source>
        <translation>de %1 s à %2 s</translation>
    </message>
</context>
<context>
    <name>ui::StepPlot</name>
    <message>
        <source>The step against time</source>
        <translation>Le pas selon le temps</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>exact</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>The exact way, the slopes that the method took, and its end</source>
        <translation>Le chemin exact, les pentes que la méthode a prises, et son arrivée</translation>
    </message>
</context>
<context>
    <name>ui::StepTable</name>
    <message>
        <source>The step in numbers</source>
        <translation>Le pas en chiffres</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Mean slope</source>
        <translation>Pente moyenne</translation>
    </message>
    <message>
        <source>End, %1</source>
        <translation>Fin, %1</translation>
    </message>
    <message>
        <source>End, exact</source>
        <translation>Fin, exacte</translation>
    </message>
    <message>
        <source>By a Taylor series from the same start</source>
        <translation>Par une série de Taylor depuis le même départ</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>%1 in %2
slope in %3</source>
        <translation>%1 en %2
pente en %3</translation>
    </message>
    <message>
        <source>Error
in m</source>
        <translation>Erreur
en m</translation>
    </message>
    <message>
        <source>The slopes that the method took on its way, and where other methods end</source>
        <translation>Les pentes que la méthode a prises en chemin, et où arrivent d’autres méthodes</translation>
    </message>
    <message>
        <source>Share of the slope in the mean that the step is taken with</source>
        <translation>Part de la pente dans la moyenne avec laquelle le pas est fait</translation>
    </message>
    <message>
        <source>%1 at the start and the end, and as a slope how fast it changes</source>
        <translation>%1 au début et à la fin, et comme pente sa vitesse de variation</translation>
    </message>
    <message>
        <source>Distance of the end from the exact one, in m: the error of this step alone</source>
        <translation>Distance entre l’arrivée et l’arrivée exacte, en m&#xa0;: l’erreur de ce seul pas</translation>
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
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>must be %1, got %2</source>
        <translation>attendu&#xa0;: %1&#xa0;; lu&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is too large or too small to reckon with</source>
        <translation>%1 est trop grand ou trop petit pour les calculs</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>clé inconnue %1</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>figure deux fois</translation>
    </message>
    <message>
        <source>must have %1 entries, got %2</source>
        <translation>éléments attendus&#xa0;: %1&#xa0;; lus&#xa0;: %2</translation>
    </message>
    <message>
        <source>must have %1 to %2 entries, got %3</source>
        <translation>éléments attendus&#xa0;: de %1 à %2&#xa0;; lus&#xa0;: %3</translation>
    </message>
</context>
<context>
    <name>ui::TaskRow</name>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Compute in the background; the same button stops it</source>
        <translation>Calculer en arrière-plan&#xa0;; le même bouton arrête</translation>
    </message>
</context>
<context>
    <name>ui::TimeCommands</name>
    <message>
        <source>Go to a time</source>
        <translation>Aller à un instant</translation>
    </message>
    <message>
        <source>Simulated time in s</source>
        <translation>Temps simulé en s</translation>
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
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>events from %1</source>
        <translation>événements depuis %1</translation>
    </message>
    <message>
        <source>%1 s: %2, weight: %3</source>
        <translation>%1 s&#xa0;: %2, bille&#xa0;: %3</translation>
    </message>
    <message>
        <source>The recording from its start to its end, with marks for events. A click or dragging shows another moment; Home, End and the arrow keys do, too.</source>
        <translation>L’enregistrement du début à la fin, avec des marques pour les événements. Un clic ou glisser montre un autre instant&#xa0;; Début, Fin et les flèches aussi.</translation>
    </message>
</context>
<context>
    <name>ui::Tour</name>
    <message>
        <source>Tour</source>
        <translation>Visite</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>La scène</translation>
    </message>
    <message>
        <source>Weights on ropes. Filled ones follow the first method, rings the others. At the start drag a weight to turn its rope; the wheel zooms.</source>
        <translation>Des billes accrochées à des cordes. Les pleines suivent la première méthode, les anneaux les autres. Au départ, glissez une bille pour tourner sa corde&#xa0;; la molette zoome.</translation>
    </message>
    <message>
        <source>Play and cut</source>
        <translation>Lire et couper</translation>
    </message>
    <message>
        <source>Space plays and stops. C cuts all ropes, R goes back to the start. Slow motion makes an impact last for seconds.</source>
        <translation>Espace lance et arrête. C coupe toutes les cordes, R revient au début. Le ralenti fait durer un choc plusieurs secondes.</translation>
    </message>
    <message>
        <source>Step by step</source>
        <translation>Pas à pas</translation>
    </message>
    <message>
        <source>The arrow keys → and ← go by one step, I goes to the next impact. Drag on this line to see any moment again.</source>
        <translation>Les flèches → et ← avancent et reculent d’un pas, I va au choc suivant. Glissez sur cette ligne pour revoir n’importe quel instant.</translation>
    </message>
    <message>
        <source>Where the energy goes</source>
        <translation>Où va l’énergie</translation>
    </message>
    <message>
        <source>The total should be a flat line. What it climbs or falls was made or lost by the method, not by nature.</source>
        <translation>La courbe de l’énergie totale devrait être plate. Ce qu’elle monte ou descend, c’est la méthode qui l’a créé ou perdu, pas la nature.</translation>
    </message>
    <message>
        <source>Methods side by side</source>
        <translation>Les méthodes côte à côte</translation>
    </message>
    <message>
        <source>Up to four methods compute the same scene. Choose them and their steps here, and see who is right. Lessons, at the top right, has scenes to begin with.</source>
        <translation>Jusqu’à quatre méthodes calculent la même scène. Choisissez-les ici avec leurs pas, et voyez laquelle a raison. Leçons, en haut à droite, propose des scènes pour débuter.</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>End the tour; the Help menu has it again</source>
        <translation>Terminer la visite&#xa0;; le menu Aide la propose de nouveau</translation>
    </message>
    <message>
        <source>Show the hint before</source>
        <translation>Montrer l’indication précédente</translation>
    </message>
    <message>
        <source>Go on with the tour, or end it</source>
        <translation>Poursuivre la visite, ou la terminer</translation>
    </message>
</context>
<context>
    <name>ui::TradeWindow</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Vitesse et précision</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilité</translation>
    </message>
    <message>
        <source>%1 is run %2 now.</source>
        <translation>%1 est maintenant la simulation %2.</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Ce qui est mesuré</translation>
    </message>
    <message>
        <source>What accuracy costs, or how large steps may be</source>
        <translation>Ce que coûte la précision, ou combien les pas peuvent être grands</translation>
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
        <translation>%1 en reste loin avec tous les réglages mesurés</translation>
    </message>
    <message>
        <source>%1 needs no more than %2</source>
        <translation>%1 demande au plus %2</translation>
    </message>
    <message>
        <source>%1 would need %2 (extrapolated along its order)</source>
        <translation>%1 demanderait %2 (extrapolé selon son ordre)</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 demande %2</translation>
    </message>
    <message>
        <source>Measured over %1 s.</source>
        <translation>Mesuré sur %1 s.</translation>
    </message>
    <message>
        <source>Measured over the first %1 s of %2 s: later not even the reference solution knows to 10⁻⁶ m where the weights are.</source>
        <translation>Mesuré sur les premières %1 s de %2 s&#xa0;: ensuite, même la solution de référence ne connaît pas à 10⁻⁶ m près la position des billes.</translation>
    </message>
    <message>
        <source>%1: no order seen</source>
        <translation>%1&#xa0;: aucun ordre visible</translation>
    </message>
    <message>
        <source>%1: order %2</source>
        <translation>%1&#xa0;: ordre %2</translation>
    </message>
    <message>
        <source>a tolerance of %1 and %2 of computing</source>
        <translation>une tolérance de %1 et %2 de calcul</translation>
    </message>
    <message>
        <source>a step of %1 and %2 of computing</source>
        <translation>un pas de %1 et %2 de calcul</translation>
    </message>
    <message>
        <source>%1: none that was tried</source>
        <translation>%1&#xa0;: aucun des pas essayés</translation>
    </message>
    <message>
        <source>%1: any</source>
        <translation>%1&#xa0;: n’importe lequel</translation>
    </message>
    <message>
        <source>%1: %2 s</source>
        <translation>%1&#xa0;: %2 s</translation>
    </message>
    <message>
        <source>Largest step that stays bounded over %1 s, that is, makes less energy out of nothing than the scene has to move with. %2.</source>
        <translation>Plus grand pas qui reste borné sur %1 s, c’est-à-dire qui crée moins d’énergie à partir de rien que la scène n’en a pour se mouvoir. %2.</translation>
    </message>
    <message>
        <source>No time was simulated.</source>
        <translation>Aucun temps n’a été simulé.</translation>
    </message>
    <message>
        <source>To be right within %1 over %2 s: %3.</source>
        <translation>Pour être exact à %1 près sur %2 s&#xa0;: %3.</translation>
    </message>
</context>
<context>
    <name>ui::TravelBar</name>
    <message>
        <source>How far the computing has come</source>
        <translation>Où en est le calcul</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>Arrêter (Échap)</translation>
    </message>
    <message>
        <source>Computing: %1 s</source>
        <translation>Calcul&#xa0;: %1 s</translation>
    </message>
    <message>
        <source>Computing one step for %1 s</source>
        <translation>Calcul d’un seul pas depuis %1 s</translation>
    </message>
</context>
<context>
    <name>ui::UndoCommands</name>
    <message>
        <source>Undone</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Done again</source>
        <translation>Rétabli</translation>
    </message>
    <message>
        <source>Done again: %1</source>
        <translation>Rétabli&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>ui::WeightChart</name>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
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
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>The first %1 of %2 weights</source>
        <translation>Les %1 premières billes sur %2</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Weight %1</source>
        <translation>Bille %1</translation>
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
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Coeff. traînée</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Hangs on</source>
        <translation>Accrochée à</translation>
    </message>
    <message>
        <source>Pivot x</source>
        <translation>Pivot x</translation>
    </message>
    <message>
        <source>Pivot y</source>
        <translation>Pivot y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Angle initial</translation>
    </message>
    <message>
        <source>Angular velocity</source>
        <translation>Vitesse angulaire</translation>
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
        <translation>Vitesse x</translation>
    </message>
    <message>
        <source>Velocity y</source>
        <translation>Vitesse y</translation>
    </message>
    <message>
        <source>must be %1, got “%2”</source>
        <translation>attendu&#xa0;: %1&#xa0;; lu&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>like #e69f00, or automatic</source>
        <translation>de la forme #e69f00, ou automatique</translation>
    </message>
    <message>
        <source>%1, %2 or %3</source>
        <translation>%1, %2 ou %3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>corde</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>tige</translation>
    </message>
    <message>
        <source>Color of the weight, such as #e69f00, or automatic</source>
        <translation>Couleur de la bille, par exemple #e69f00, ou automatique</translation>
    </message>
    <message>
        <source>What holds the weight at the start: a rope, a rod, or nothing</source>
        <translation>Ce qui tient la bille au départ&#xa0;: une corde, une tige ou rien</translation>
    </message>
    <message>
        <source>Where the rope is tied: x from the left wall, y from the floor, in m</source>
        <translation>Où la corde est attachée&#xa0;: x depuis le mur gauche, y depuis le sol, en m</translation>
    </message>
    <message>
        <source>Angular velocity ω at the start, in °/s, positive counterclockwise</source>
        <translation>Vitesse angulaire ω au départ, en °/s, positive dans le sens antihoraire</translation>
    </message>
    <message>
        <source>Center of the weight at the start: x from the left wall, y from the floor, in m</source>
        <translation>Centre de la bille au départ&#xa0;: x depuis le mur gauche, y depuis le sol, en m</translation>
    </message>
    <message>
        <source>Velocity v at the start: x to the right, y up, in m/s</source>
        <translation>Vitesse v au départ&#xa0;: x vers la droite, y vers le haut, en m/s</translation>
    </message>
    <message>
        <source>Mass m, in kg. It does not matter for a swing without air; with air a heavier weight is slowed down less.</source>
        <translation>Masse m, en kg. Elle ne compte pas pour une oscillation sans air&#xa0;; dans l’air, une bille plus lourde est moins freinée.</translation>
    </message>
    <message>
        <source>Radius r, in m. Air meets the area A = π r².</source>
        <translation>Rayon r, en m. L’air rencontre la surface A = π r².</translation>
    </message>
    <message>
        <source>Drag coefficient c_d, without unit: how well the shape is held up by air. 0.47 for a sphere.</source>
        <translation>Coefficient de traînée c_d, sans unité&#xa0;: à quel point l’air retient la forme. 0,47 pour une sphère.</translation>
    </message>
    <message>
        <source>Length of the rope L, in m: from its pivot to the center of the weight. A small swing takes T = 2π √(L/g).</source>
        <translation>Longueur de la corde L, en m&#xa0;: de son pivot au centre de la bille. Une petite oscillation dure T = 2π √(L/g).</translation>
    </message>
    <message>
        <source>Angle θ of the rope at the start, in degrees from straight down, positive to the right.</source>
        <translation>Angle θ de la corde au départ, en degrés depuis la verticale vers le bas, positif vers la droite.</translation>
    </message>
</context>
<context>
    <name>ui::WeightDrag</name>
    <message>
        <source>Angle %1°</source>
        <translation>Angle %1°</translation>
    </message>
    <message>
        <source>Length %1 m</source>
        <translation>Longueur %1 m</translation>
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
        <translation>changement de vitesse</translation>
    </message>
    <message>
        <source>move of a weight</source>
        <translation>déplacement d’une bille</translation>
    </message>
    <message>
        <source>overlaps another weight</source>
        <translation>recouvre une autre bille</translation>
    </message>
    <message>
        <source>outside the room</source>
        <translation>hors de la pièce</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>impossible</translation>
    </message>
</context>
<context>
    <name>ui::WeightsClipboard</name>
    <message>
        <source>Weight %1, %2: %3</source>
        <translation>Bille %1, %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>a weight on a rope has none, got “%1”</source>
        <translation>sans objet pour une bille sur une corde&#xa0;; lu&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a weight that hangs on nothing has none, got “%1”</source>
        <translation>sans objet pour une bille accrochée à rien&#xa0;; lu&#xa0;: «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>Line %1 has another number of columns than the first (%2, not %3).</source>
        <translation>La ligne %1 n’a pas le même nombre de colonnes que la première (%2, non %3).</translation>
    </message>
    <message>
        <source>There are too many columns: %1, and from %2 on the table has %3.</source>
        <translation>Il y a trop de colonnes&#xa0;: %1, alors qu’à partir de %2 le tableau en a %3.</translation>
    </message>
    <message>
        <source>There would be more than %1 weights.</source>
        <translation>Il y aurait plus de %1 billes.</translation>
    </message>
    <message>
        <source>The clipboard holds no text.</source>
        <translation>Le presse-papiers ne contient pas de texte.</translation>
    </message>
    <message>
        <source>There are only headings.</source>
        <translation>Il n’y a que des en-têtes.</translation>
    </message>
</context>
<context>
    <name>ui::WeightsForm</name>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>Bille</translation>
    </message>
    <message>
        <source>Which weight the fields below belong to, counted from the left</source>
        <translation>À quelle bille se rapportent les champs ci-dessous, comptée depuis la gauche</translation>
    </message>
    <message>
        <source>Rope</source>
        <translation>Corde</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Angle initial</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Drag coefficient</source>
        <translation>Coefficient de traînée</translation>
    </message>
    <message>
        <source>All weights in a table…</source>
        <translation>Toutes les billes en tableau…</translation>
    </message>
    <message>
        <source>Change many weights at once, and copy them from and to spreadsheets</source>
        <translation>Changer plusieurs billes à la fois, et les copier depuis et vers un tableur</translation>
    </message>
</context>
<context>
    <name>ui::WeightsModel</name>
    <message>
        <source>%1 !</source>
        <translation>%1&#xa0;!</translation>
    </message>
</context>
<context>
    <name>ui::WeightsTable</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Tableau des billes</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a weight</source>
        <translation>Ajouter une bille</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Add a copy of each selected weight</source>
        <translation>Ajouter une copie de chaque bille sélectionnée</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Remove the selected weights</source>
        <translation>Retirer les billes sélectionnées</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the selected cells for a spreadsheet</source>
        <translation>Copier les cellules sélectionnées pour un tableur</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Paste cells, from a spreadsheet too, over those from the first selected one on</source>
        <translation>Coller des cellules, d’un tableur aussi, par-dessus celles à partir de la première sélectionnée</translation>
    </message>
    <message>
        <source>Paste as new</source>
        <translation>Coller en ajout</translation>
    </message>
    <message>
        <source>Add what was copied as new weights</source>
        <translation>Ajouter ce qui a été copié comme nouvelles billes</translation>
    </message>
    <message>
        <source>Fill down</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Give all selected rows what the first of them holds</source>
        <translation>Donner à toutes les lignes sélectionnées ce que contient la première</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>change of %1</source>
        <translation>changement (%1)</translation>
    </message>
    <message>
        <source>Nothing was changed. %1</source>
        <translation>Rien n’a été changé. %1</translation>
    </message>
    <message>
        <source>addition of a weight</source>
        <translation>ajout d’une bille</translation>
    </message>
    <message>
        <source>duplication of weights</source>
        <translation>duplication de billes</translation>
    </message>
    <message>
        <source>removal of weights</source>
        <translation>retrait de billes</translation>
    </message>
    <message>
        <source>Rows copied: %1</source>
        <translation>Lignes copiées&#xa0;: %1</translation>
    </message>
    <message>
        <source>pasting</source>
        <translation>collage</translation>
    </message>
    <message>
        <source>Rows pasted: %1</source>
        <translation>Lignes collées&#xa0;: %1</translation>
    </message>
    <message>
        <source>Rows pasted: %1; new weights: %2</source>
        <translation>Lignes collées&#xa0;: %1&#xa0;; nouvelles billes&#xa0;: %2</translation>
    </message>
    <message>
        <source>filling down</source>
        <translation>remplissage vers le bas</translation>
    </message>
    <message>
        <source>One row for each weight. Return edits a cell, of all selected rows at once.</source>
        <translation>Une ligne par bille. Entrée modifie une cellule, dans toutes les lignes sélectionnées à la fois.</translation>
    </message>
</context>
<context>
    <name>ui::WindowFace</name>
    <message>
        <source>Bring them back</source>
        <translation>Les récupérer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Undo the change</source>
        <translation>Annuler le changement</translation>
    </message>
    <message>
        <source>Unsaved changes cannot be kept for a crash: %1</source>
        <translation>Les changements non enregistrés ne peuvent être mis à l’abri d’un plantage&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Colors</source>
        <translation>C&amp;ouleurs</translation>
    </message>
    <message>
        <source>Like the &amp;desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Taille du te&amp;xte</translation>
    </message>
    <message>
        <source>&amp;Normal</source>
        <translation>&amp;Normale</translation>
    </message>
    <message>
        <source>&amp;Large</source>
        <translation>&amp;Grande</translation>
    </message>
    <message>
        <source>&amp;Very large</source>
        <translation>&amp;Très grande</translation>
    </message>
    <message>
        <source>&amp;Drawn by</source>
        <translation>&amp;Dessiné par</translation>
    </message>
    <message>
        <source>&amp;Automatic choice</source>
        <translation>Choix &amp;automatique</translation>
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
        <translation>Lan&amp;gue</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>Non appliqué&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1[*] – Angry Cuts</source>
        <translation>%1[*] – Angry Cuts</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Nouvelle scène</translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation>Dessiné par %1</translation>
    </message>
</context>
<context>
    <name>ui::WindowPanels</name>
    <message>
        <source>Lesson</source>
        <translation>Leçon</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>Billes</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Simulations</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Inside a step</source>
        <translation>Dans un pas</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Weights table</source>
        <translation>Tableau des billes</translation>
    </message>
</context>
<context>
    <name>ui::WorkPrecisionPlot</name>
    <message>
        <source>slope %1</source>
        <translation>pente %1</translation>
    </message>
    <message>
        <source>Computing time per simulated second</source>
        <translation>Temps de calcul par seconde simulée</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Largest position error</source>
        <translation>Plus grande erreur de position</translation>
    </message>
</context>
</TS>
