/** Commands of scripts as rows: number, command, state, time. */
import type { CommandState } from "@corridor/protocol";
import {
  ArrowRight,
  Asterisk,
  Ban,
  Check,
  Hourglass,
  Inbox,
  LoaderCircle,
  ListX,
  type IconNode,
} from "lucide";
import { memo, useMemo, type ComponentProps } from "react";
import { useTranslation } from "react-i18next";
import { Icon } from "../../ui/Icon.tsx";
import { Chip } from "../../ui/Chip.tsx";
import { classNames } from "../../ui/class-names.ts";
import type { ListedCommand } from "../../simulator/protocol/worker-messages.ts";
import { commandText, cutShortAfter } from "../../text/command-text.ts";
import { useSelectedCommand } from "./use-selected-command.ts";
import styles from "./command-table.module.css";

type Tone = ComponentProps<typeof Chip>["tone"];

const looks: Record<CommandState, { tone: Tone; icon: IconNode }> = {
  accepted: { tone: "ring", icon: Inbox },
  delivered: { tone: "ring", icon: ArrowRight },
  started: { tone: "live", icon: LoaderCircle },
  completed: { tone: "good", icon: Check },
  collided: { tone: "bad", icon: Asterisk },
  cancelled: { tone: "dashed", icon: Ban },
  superseded: { tone: "dashed", icon: ListX },
  expired: { tone: "dashed", icon: Hourglass },
};

export function CommandTable({ commands }: { commands: readonly ListedCommand[] }) {
  const { t, i18n } = useTranslation();
  const selected = useSelectedCommand();
  const time = useMemo(
    () =>
      new Intl.DateTimeFormat(i18n.language, {
        timeStyle: "medium",
        hour12: false,
        numberingSystem: "latn",
      }),
    [i18n.language],
  );
  return (
    <table className={styles["commands"]}>
      <thead className="visually-hidden">
        <tr>
          <th scope="col">{t("remote.seq")}</th>
          <th scope="col">{t("remote.command")}</th>
          <th scope="col">{t("remote.state")}</th>
          <th scope="col">{t("remote.time")}</th>
        </tr>
      </thead>
      <tbody>
        {commands.map((record) => (
          <CommandRow
            key={record.seq}
            record={record}
            isSelected={record.seq === selected}
            time={time}
          />
        ))}
      </tbody>
    </table>
  );
}

interface CommandRowProps {
  record: ListedCommand;
  /** whether the displayed tick of the timeline belongs to the command */
  isSelected: boolean;
  time: Intl.DateTimeFormat;
}

/** The worker sends copies of all records with each change of one, several times a command. */
function isSameRow(before: CommandRowProps, after: CommandRowProps): boolean {
  const [a, b] = [before.record, after.record];
  return (
    before.isSelected === after.isSelected &&
    before.time === after.time &&
    a.state === b.state &&
    a.reason === b.reason &&
    a.distance === b.distance &&
    a.acceptedAt === b.acceptedAt
  );
}

const CommandRow = memo(function CommandRow({ record, isSelected, time }: CommandRowProps) {
  const { t } = useTranslation();
  const { tone, icon } = looks[record.state];
  const distance = cutShortAfter(record);
  return (
    <tr
      aria-current={isSelected || undefined}
      className={classNames(
        styles["row"],
        record.state === "started" && styles["running"],
        isSelected && styles["selected"],
      )}
    >
      <td className={styles["seq"]}>{record.seq}</td>
      <td>
        <span dir="ltr" className={styles["command"]}>
          {commandText(record.command)}
        </span>
        {distance !== null && (
          <span className={styles["detail"]}>{t("remote.after", { distance })}</span>
        )}
        {record.state === "expired" && (
          <span className={styles["detail"]}>
            {t("remote.olderThan", { seconds: record.ttl / 1000 })}
          </span>
        )}
        {record.reason !== null && (
          <p className={styles["reason"]}>{t(`remote.cancel.${record.reason}`)}</p>
        )}
      </td>
      <td className={styles["state"]}>
        <Chip tone={tone} icon={<Icon of={icon} />}>
          {t(`remote.${record.state}`)}
        </Chip>
      </td>
      <td className={styles["time"]}>
        <time dateTime={record.acceptedAt}>{time.format(new Date(record.acceptedAt))}</time>
      </td>
    </tr>
  );
}, isSameRow);
