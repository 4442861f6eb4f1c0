/**
 * The text that connects a program of the chosen kind, ready to copy, and whether such a program has
 * reached the robot. The displayed text masks the key, because a projector may show it.
 */
import { quickstartIds, quickstarts, type QuickstartId } from "@corridor/quickstarts";
import { Check, Download } from "lucide";
import { useState } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { maskKey, type RobotAddress } from "../../model/remote/robot-address.ts";
import { useServices } from "../../model/use-services.ts";
import { joinSentences } from "../../text/joined.ts";
import type { RemoteSession } from "../../simulator/protocol/worker-messages.ts";
import { Chip } from "../../ui/Chip.tsx";
import { CodeField } from "../../ui/CodeField.tsx";
import { CopyButton } from "../../ui/CopyButton.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { Select } from "../../ui/Select.tsx";
import { connectedClients } from "./connected-clients.ts";
import { provideUrlKey, readUrlKey, tabStorage } from "./url-key.ts";
import { useGateways } from "./use-gateways.ts";
import panel from "./remote.module.css";
import styles from "./connect-with.module.css";

/** Longer texts scroll. */
const MAX_LINES = 12;
/** The kind that the page shows first; its script uses the library. */
const FIRST = "python";

interface ConnectWithProps {
  address: RobotAddress;
  session: RemoteSession;
}

export function ConnectWith({ address, session }: ConnectWithProps) {
  const { t, ready } = useTranslation(["words", "watch", "connect"], { useSuspense: false });
  const { remote } = useServices();
  const [chosen, setChosen] = useState<QuickstartId>(FIRST);
  const [isRefused, setRefused] = useState(false);
  const [isFailed, setFailed] = useState(false);
  const [urlKey, setUrlKey] = useState(() => readUrlKey(tabStorage, session.id));
  const gateways = useGateways(session);
  const scripts = useStore(remote, (state) => state.scripts);
  const clients = connectedClients(session.id, scripts);
  const quickstart = quickstarts[chosen];
  const nameOf = useNames();
  const note = useNote(chosen);

  const offered = quickstartIds.filter((id) => {
    const { name, gateway } = quickstarts[id];
    return (ready || name !== null) && (gateway === null || gateways.includes(gateway));
  });
  const options = offered.map((value) => {
    const isConnected = clients.has(quickstarts[value].client);
    return { value, label: isConnected ? `${nameOf(value)} ✓` : nameOf(value) };
  });
  const textWith = (key: string, keyOfUrl: string): string => {
    const { origin } = new URL(address.full);
    return quickstart.text({ origin, id: session.id, key, urlKey: keyOfUrl });
  };
  const full = textWith(address.key, urlKey ?? "");
  const masked = textWith(maskKey(address.key), maskKey(urlKey ?? ""));
  const isComplete = !quickstart.hasUrlKey || urlKey !== null;
  // Where the browser refuses to copy, the user needs the whole text to select it.
  const displayed = (isRefused && isComplete ? full : masked).trimEnd();
  const withUrlKey = async (): Promise<string | null> => {
    const key = await provideUrlKey(fetch, tabStorage, session);
    setFailed(key === null);
    setUrlKey(key);
    return key === null ? null : textWith(address.key, key);
  };
  return (
    <section className={panel["section"]} aria-labelledby="connect-heading">
      <div className={panel["bar"]}>
        <h2 id="connect-heading" className={panel["heading"]}>
          {t("remote.connectWith")}
        </h2>
        <Select
          className={styles["kind"]}
          label={t("remote.connectWith")}
          value={chosen}
          options={options}
          onChange={(id) => {
            setChosen(id);
            setFailed(false);
          }}
        />
        <CopyButton
          text={quickstart.hasUrlKey ? withUrlKey : full}
          label={t("remote.copyScript")}
          done={t("remote.copied")}
          kind="quiet"
          size="small"
          onRefused={() => setRefused(true)}
        />
      </div>
      <CodeField
        label={t("remote.script")}
        lines={Math.min(displayed.split("\n").length, MAX_LINES)}
        text={displayed}
      />
      <p className={panel["note"]}>
        <output>{isFailed && t("remote.actionFailed")}</output>
        {!isFailed && (isRefused && isComplete ? t("remote.copyByHand") : note)}
      </p>
      <div className={styles["links"]}>
        {chosen === FIRST && (
          <a className={styles["link"]} href="/corridor.py" download="corridor.py">
            <Icon of={Download} size={16} />
            {t("remote.library")}
          </a>
        )}
        {/* Opens in a new tab: leaving this page ends the robot. */}
        {ready && (
          <a
            className={styles["link"]}
            href={`/docs#connect-${chosen}`}
            target="_blank"
            rel="noopener"
          >
            {t("watch:learn")}
          </a>
        )}
        <output>
          {ready && clients.has(quickstart.client) && (
            <Chip tone="good" icon={<Icon of={Check} />}>
              {t("connect:arrived")}
            </Chip>
          )}
        </output>
      </div>
    </section>
  );
}

/** Names that differ between languages; the others are those of products. */
function useNames(): (id: QuickstartId) => string {
  const { t } = useTranslation(["words", "connect"], { useSuspense: false });
  const translated: Partial<Record<QuickstartId, string>> = {
    plainPython: t("connect:names.plainPython"),
    generated: t("connect:names.generated"),
    rosbridge: t("connect:names.rosbridge"),
    micromouse: t("connect:names.micromouse"),
  };
  return (id) => quickstarts[id].name ?? translated[id] ?? id;
}

/** What to do with the copied text. */
function useNote(id: QuickstartId): string {
  const { t, ready } = useTranslation(["words", "connect"], { useSuspense: false });
  const { file, command, needs, hasUrlKey } = quickstarts[id];
  if (id === FIRST) return t("remote.libraryNote");
  if (!ready) return "";
  const needed = needs === null ? [] : [t("remote.scriptNeeds", { program: needs })];
  if (hasUrlKey) return t("connect:url");
  if (id === "micromouse") return joinSentences(t, [t("connect:program"), ...needed]);
  if (id === "viple") return joinSentences(t, [t("connect:diagram"), ...needed]);
  if (file === null) return t("connect:terminal");
  if (command === null) return t("connect:file", { file });
  return joinSentences(t, [t("remote.scriptNote", { file, command }), ...needed]);
}
