import { useTranslation } from "react-i18next";
import { NumberField } from "../../../ui/NumberField.tsx";

interface BoundedNumberProps {
  label: string;
  note?: string;
  value: number;
  min: number;
  max: number;
  onChange: (value: number) => void;
}

/** A whole number, whose error names its bounds. */
export function BoundedNumber({ min, max, ...field }: BoundedNumberProps) {
  const { t } = useTranslation("lessonEditor", { useSuspense: false });
  return (
    <NumberField {...field} bounds={{ min, max, whole: true }} error={t("number", { min, max })} />
  );
}
