import { FileMenuItems } from "../features/files/FileMenuItems.tsx";
import { RaceMenuItem } from "../features/race/RaceButton.tsx";

/** The menu items for files. Their code is a separate chunk. */
export function FileItems() {
  return <FileMenuItems race={<RaceMenuItem />} />;
}
