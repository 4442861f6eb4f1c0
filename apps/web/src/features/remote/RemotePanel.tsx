/** The Remote side of the panel: connection, address with key, scripts to copy, commands. */
import { useStore } from "zustand";
import { useServices } from "../../app/services.ts";
import { AddressFields } from "./AddressFields.tsx";
import { CommandList } from "./CommandList.tsx";
import { ConnectionCard } from "./ConnectionCard.tsx";
import { KeyList } from "./KeyList.tsx";
import { robotAddress } from "./robot-address.ts";
import { ScriptList } from "./ScriptList.tsx";
import { Snippets } from "./Snippets.tsx";
import styles from "./remote.module.css";

export function RemotePanel() {
  const { remote } = useServices();
  const session = useStore(remote, (state) => state.session);
  const kind = useStore(remote, (state) => state.status.kind);
  const address = session === null ? null : robotAddress(session);
  const isShown = session !== null && address !== null && kind !== "off" && kind !== "over";
  return (
    <div className={styles["panel"]}>
      <div className={styles["section"]}>
        <ConnectionCard />
        {isShown && <AddressFields address={address} session={session} />}
      </div>
      {isShown && <Snippets address={address} />}
      {isShown && <ScriptList session={session} />}
      {isShown && <KeyList session={session} />}
      <CommandList />
    </div>
  );
}
