/**
 * Receives files: dropped onto the page, pasted, or chosen in the file picker. This module listens
 * from the start, so it is small; the code that reads files is a separate chunk.
 */

/** The part of `File` that is used. */
export interface TextFile {
  name: string;
  /** media type; empty if the browser does not know it */
  type?: string;
  /** in bytes */
  size: number;
  text: () => Promise<string>;
  /** missing for pasted text, which is no binary file */
  arrayBuffer?: () => Promise<ArrayBuffer>;
}

interface IncomingPorts {
  /** called when a drag with files starts or ends over the page */
  over: (isOver: boolean) => void;
  take: (files: readonly TextFile[]) => void;
  /** called when text is pasted outside of a field */
  pasted: (text: string) => void;
}

/**
 * Listens on the window.
 * @returns a function that removes the listeners
 */
export function listenForFiles({ over, take, pasted }: IncomingPorts): () => void {
  const end = new AbortController();
  const { signal } = end;
  // A drag enters an element before it leaves the previous one.
  let depth = 0;
  window.addEventListener(
    "dragenter",
    (event) => {
      if (!hasFiles(event)) return;
      depth++;
      over(true);
    },
    { signal },
  );
  window.addEventListener(
    "dragleave",
    (event) => {
      if (!hasFiles(event)) return;
      depth = Math.max(0, depth - 1);
      if (depth === 0) over(false);
    },
    { signal },
  );
  window.addEventListener(
    "dragover",
    (event) => {
      if (!hasFiles(event)) return;
      // Without this, the browser would leave the page to open the file.
      event.preventDefault();
      if (event.dataTransfer !== null) event.dataTransfer.dropEffect = "copy";
    },
    { signal },
  );
  window.addEventListener(
    "drop",
    (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      depth = 0;
      over(false);
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length > 0) take(files);
    },
    { signal },
  );
  window.addEventListener(
    "paste",
    (event) => {
      if (isField(event.target) || event.clipboardData === null) return;
      // A dialog or popover on top of the page receives the paste.
      if (document.querySelector("dialog:modal, :popover-open") !== null) return;
      const files = [...event.clipboardData.files];
      const text = event.clipboardData.getData("text/plain");
      if (files.length === 0 && text.trim() === "") return;
      event.preventDefault();
      if (files.length > 0) take(files);
      else pasted(text);
    },
    { signal },
  );
  return () => end.abort();
}

const DOCUMENTS = ".json,.txt,.maze,.map,.num,.maz,application/json,text/plain";

/**
 * Opens the file picker. `take` is not called if the user cancels.
 * @param accept types of files that the picker offers
 */
export function chooseFiles(take: (files: readonly TextFile[]) => void, accept = DOCUMENTS): void {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = true;
  input.accept = accept;
  input.addEventListener("change", () => take([...(input.files ?? [])]));
  input.click();
}

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") === true;
}

function isField(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || target.matches("input, textarea, select"))
  );
}
