import { useTranslation } from "react-i18next";
import { NumberField } from "../../../ui/NumberField.tsx";

interface BoundedNumberProps {
  label: string;
  value: number;
  min: number;
  max: number;
  onChange: (value: number) => void;
}

/** A whole number, whose error names its bounds. */
export function BoundedNumber({ label, value, min, max, onChange }: BoundedNumberProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  return (
    <NumberField
      label={label}
      value={value}
      bounds={{ min, max, whole: true }}
      error={t("number", { min, max })}
      onChange={onChange}
    />
  );
}
