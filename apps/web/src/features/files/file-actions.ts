/** What menus anywhere on the page can do with files; the `FileDoor` around the page does it. */
import { createContext, useContext } from "react";

export interface FileActions {
  /** lets the reader choose files to open */
  choose: () => void;
  /** opens the dialog that saves a picture of maze and trail */
  savePicture: () => void;
}

const FileActionsContext = createContext<FileActions | null>(null);
export const FileActionsProvider = FileActionsContext.Provider;

export function useFileActions(): FileActions {
  const actions = useContext(FileActionsContext);
  if (actions === null) throw new Error("useFileActions needs a FileDoor above it");
  return actions;
}
