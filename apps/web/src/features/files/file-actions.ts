/** What menus can do with files. The `FileDropTarget` around the page implements it. */
import { createContext, useContext } from "react";

export interface FileActions {
  /** opens the file picker */
  choose: () => void;
  /** opens the dialog that saves a picture of the maze and the trail */
  savePicture: () => void;
  /** opens the dialog that saves the maze for contests */
  saveContest: () => void;
}

const FileActionsContext = createContext<FileActions | null>(null);
export const FileActionsProvider = FileActionsContext.Provider;

export function useFileActions(): FileActions {
  const actions = useContext(FileActionsContext);
  if (actions === null) throw new Error("useFileActions needs a FileDropTarget above it");
  return actions;
}
