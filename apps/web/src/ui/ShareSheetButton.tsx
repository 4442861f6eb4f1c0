/** Opens the share sheet of the device. Renders nothing in browsers without one. */
import { Send } from "lucide";
import { Button, type ButtonProps } from "./Button.tsx";
import { Icon } from "./Icon.tsx";

interface ShareSheetButtonProps extends Pick<ButtonProps, "size"> {
  data: ShareData;
  label: string;
}

export function ShareSheetButton({ data, label, ...rest }: ShareSheetButtonProps) {
  if (!("share" in navigator)) return null;
  return (
    <Button
      {...rest}
      icon={<Icon of={Send} />}
      // The user may close the share sheet.
      onClick={() => void navigator.share(data).catch(() => undefined)}
    >
      {label}
    </Button>
  );
}
