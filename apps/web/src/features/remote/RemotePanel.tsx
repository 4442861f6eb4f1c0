/**
 * The Remote panel: connection, address, the texts that connect a program, and its commands; the
 * rest is behind "More".
 */
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { AddressField } from "./AddressField.tsx";
import { ConnectWith } from "./ConnectWith.tsx";
import { ConnectionCard } from "./ConnectionCard.tsx";
import { PausedNote } from "./PausedNote.tsx";
import { RecentCommands } from "./RecentCommands.tsx";
import { RemoteMore } from "./RemoteMore.tsx";
import { robotAddress } from "../../model/remote/robot-address.ts";
import panel from "./remote.module.css";
import styles from "./remote-panel.module.css";

export function RemotePanel() {
  const { remote } = useServices();
  const session = useStore(remote, (state) => state.session);
  const kind = useStore(remote, (state) => state.status.kind);
  const address = session === null ? null : robotAddress(session);
  const isShown = session !== null && address !== null && kind !== "off" && kind !== "over";
  return (
    <div className={styles["panel"]}>
      <div className={panel["section"]}>
        <ConnectionCard />
        {isShown && <AddressField address={address} session={session} />}
        {isShown && <PausedNote session={session} />}
      </div>
      {isShown && <ConnectWith key={session.id} address={address} session={session} />}
      <RecentCommands />
      <RemoteMore session={isShown ? session : null} />
    </div>
  );
}
