// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/compare_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QWheelEvent>
#include <cmath>

#include "widgets/class_matrix.h"
#include "widgets/difference.h"
#include "widgets/param_row.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

/// Tables of the page.
class Tables {
public:
  explicit Tables(QString muted) : muted_(std::move(muted)) {}
  void begin(const QString& title, const QStringList& heads = {}) {
    html_ += QStringLiteral(
                 "<p style='font-weight:600; margin-bottom:3px'>%1</p><table width='100%' "
                 "cellspacing='0' cellpadding='2'>")
                 .arg(title);
    if (heads.isEmpty()) return;
    html_ += QStringLiteral("<tr style='color:%1'><td></td>").arg(muted_);
    for (const QString& head : heads) html_ += QStringLiteral("<td align='right'>%1</td>").arg(head);
    html_ += QStringLiteral("</tr>");
  }
  void row(const QString& name, const QStringList& values) {
    html_ += QStringLiteral("<tr><td>%1</td>").arg(name);
    for (const QString& value : values) html_ += QStringLiteral("<td align='right'>%1</td>").arg(value);
    html_ += QStringLiteral("</tr>");
  }
  void end() { html_ += QStringLiteral("</table>"); }
  void say(const QString& text) { html_ += QStringLiteral("<p style='color:%1'>%2</p>").arg(muted_, text); }
  const QString& html() const { return html_; }

private:
  QString muted_, html_;
};

QString signedText(long long difference) {
  if (difference == 0) return QStringLiteral("0");
  const QString size = countText(static_cast<size_t>(std::llabs(difference)));
  return (difference > 0 ? QStringLiteral("+") : QStringLiteral("−")) + size;
}

void countRow(Tables& t, const QString& name, size_t a, size_t b) {
  t.row(name,
        {countText(a), countText(b), signedText(static_cast<long long>(b) - static_cast<long long>(a))});
}

void shareRow(Tables& t, const QString& name, size_t a, size_t ofA, size_t b, size_t ofB) {
  const auto percent = [](size_t n, size_t of) {
    return 100.0 * static_cast<double>(n) / static_cast<double>(std::max<size_t>(1, of));
  };
  const double x = percent(a, ofA), y = percent(b, ofB);
  QString difference = QString::number(std::abs(y - x), 'f', 1);
  difference.prepend(difference == QStringLiteral("0.0") ? QString()
                     : y > x                             ? QStringLiteral("+")
                                                         : QStringLiteral("−"));
  t.row(name,
        {QStringLiteral("%1 %").arg(x, 0, 'f', 1), QStringLiteral("%1 %").arg(y, 0, 'f', 1), difference});
}

template <class Change, size_t N>
void changeRows(Tables& t, const std::array<size_t, N>& counts, size_t first) {
  for (size_t i = first; i < N; ++i) {
    if (counts[i] == 0) continue;
    const auto change = static_cast<Change>(i);
    const Rgb c = changeColour(change);
    t.row(QStringLiteral("<span style='color:%1'>■</span>&nbsp;%2")
              .arg(QColor(c.r, c.g, c.b).name(), changeName(change)),
          {countText(counts[i])});
  }
}

void planeRows(Tables& t, const Comparer::Result& r) {
  const SnapshotComparison& c = *r.comparison;
  QStringList lost, gained;
  for (const PlanePair& pair : c.planes) {
    if (pair.b == kNoPlane) {
      const Plane* plane = r.a->snapshot->plane(pair.a);
      lost << QObject::tr("%1 (%2 points)")
                  .arg(r.a->numbers.of(pair.a))
                  .arg(countText(plane ? plane->points : 0));
    } else if (pair.a == kNoPlane) {
      gained << QStringLiteral("<a href='plane:%1'>%2</a>").arg(pair.b).arg(r.b->numbers.of(pair.b));
    }
  }
  constexpr int kMost = 24;
  const auto list = [](const QStringList& all) {
    QString text = all.mid(0, kMost).join(QStringLiteral(", "));
    if (all.size() > kMost) text += QObject::tr(" and %1 more").arg(all.size() - kMost);
    return text;
  };
  t.say(QObject::tr("%1 planes kept, %2 lost, %3 gained.")
            .arg(countText(c.planesKept), countText(c.planesLost), countText(c.planesGained)));
  if (!lost.isEmpty()) t.say(QObject::tr("Lost: %1").arg(list(lost)));
  if (!gained.isEmpty()) t.say(QObject::tr("Gained: %1").arg(list(gained)));
}

/// Parameters and numbers, over the matrix.
QString upperPage(const Comparer::Result& r, const QString& muted) {
  const SnapshotComparison& c = *r.comparison;
  const Snapshot &a = *r.a->snapshot, &b = *r.b->snapshot;
  Tables t(muted);
  if (c.parameters.empty()) {
    t.say(QObject::tr("A and B have the same parameters. Change one: B follows, A stays."));
  } else {
    t.begin(QObject::tr("Parameters that differ"), {QStringLiteral("A"), QStringLiteral("B")});
    for (const ParamInfo* info : c.parameters)
      t.row(tableText(info->label).toHtmlEscaped(),
            {paramValueText(*info, info->get(a.params)), paramValueText(*info, info->get(b.params))});
    t.end();
  }
  const QStringList heads{QStringLiteral("A"), QStringLiteral("B"), QObject::tr("B − A")};
  t.begin(QObject::tr("Numbers"), heads);
  countRow(t, QObject::tr("Planes"), c.a.planes, c.b.planes);
  countRow(t, QObject::tr("Edges"), c.a.edges, c.b.edges);
  countRow(t, QObject::tr("Points"), c.a.points, c.b.points);
  shareRow(t, QObject::tr("Classified"), c.a.classified, c.a.points, c.b.classified, c.b.points);
  shareRow(t, QObject::tr("On planes"), c.a.onPlanes, c.a.points, c.b.onPlanes, c.b.points);
  countRow(t, QObject::tr("Records"), c.a.records, c.b.records);
  countRow(t, QObject::tr("Occupied cells"), c.a.cells, c.b.cells);
  const auto sigma = [](double metres) {
    return std::isfinite(metres) ? QStringLiteral("%1 mm").arg(1000 * metres, 0, 'f', 2)
                                 : QStringLiteral("–");
  };
  t.row(QObject::tr("Mean σ of planes"), {sigma(c.a.meanSigma), sigma(c.b.meanSigma), {}});
  t.end();

  return t.html();
}

/// What became of points, cells and planes, and times, under the matrix.
QString lowerPage(const Comparer::Result& r, const QString& muted) {
  const SnapshotComparison& c = *r.comparison;
  const Snapshot &a = *r.a->snapshot, &b = *r.b->snapshot;
  Tables t(muted);
  t.begin(QObject::tr("What became of the points"));
  changeRows<PointChange>(t, c.pointCounts, 0);
  t.row(QObject::tr("of another class, in all"), {countText(c.classesChanged)});
  t.end();
  if (c.cells) {
    t.begin(QObject::tr("What became of the cells"));
    changeRows<CellChange>(t, c.cellCounts, 1);
    t.end();
  } else {
    t.say(QObject::tr("The cells of A are %1 wide, those of B %2: maps are compared by their numbers only.")
              .arg(metresText(a.params.grid.cell), metresText(b.params.grid.cell)));
  }
  planeRows(t, r);
  t.begin(QObject::tr("Last time of each stage"), {QStringLiteral("A"), QStringLiteral("B")});
  for (size_t i = 0; i < kStageCount; ++i)
    t.row(tableText(stageLabel(static_cast<Stage>(i))),
          {secondsText(a.stages[i].seconds), secondsText(b.stages[i].seconds)});
  t.end();
  return t.html();
}

}  // namespace

/// A text as high as it is, to stand in something that scrolls.
class FittedText : public QTextBrowser {
public:
  FittedText() {
    setOpenLinks(false);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    document()->setDocumentMargin(12);
    setStyleSheet(QStringLiteral("QTextBrowser { border: none; }"));
  }
  void show(const QString& html) {
    setHtml(html);
    fit();
  }

protected:
  void resizeEvent(QResizeEvent* event) override {
    QTextBrowser::resizeEvent(event);
    fit();
  }
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }

private:
  void fit() {
    document()->setTextWidth(viewport()->width());
    setFixedHeight(static_cast<int>(std::ceil(document()->size().height())));
  }
};

ComparePanel::ComparePanel(QWidget* parent) : QWidget(parent) {
  modes_ = new QComboBox;
  modes_->setObjectName("compareMode");
  for (int i = 0; i < kCompareModes; ++i) modes_->addItem(compareModeName(static_cast<CompareMode>(i)));
  modes_->setToolTip(tr("What the views show of A and B"));
  connect(modes_, qOverload<int>(&QComboBox::activated), this,
          [this](int i) { emit modeChosen(static_cast<CompareMode>(i)); });

  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 6, 4);
  row->setSpacing(2);
  row->addWidget(modes_, 1);
  const auto button = [&](const QString& icon, const QString& tip, const auto& act) {
    auto* b = new QToolButton;
    b->setAutoRaise(true);
    b->setToolTip(tip);
    b->setAccessibleName(tip);
    setThemedIcon(b, icon);
    connect(b, &QToolButton::clicked, this, act);
    row->addWidget(b);
    return b;
  };
  button(QStringLiteral("keep"), tr("Keep the present result as A"), [this] { emit keepRequested(); });
  needA_ = {
      button(QStringLiteral("back"), tr("Back to the parameters of A"), [this] { emit backRequested(); }),
      button(QStringLiteral("swap"), tr("A becomes B and B becomes A"), [this] { emit swapRequested(); }),
      button(QStringLiteral("export"), tr("Copy as text"),
             [this] {
               QApplication::clipboard()->setText(plainText() + '\n' + matrix_->asText());
               emit copied(tr("Copied the comparison"));
             }),
      button(QStringLiteral("close"), tr("Drop A"), [this] { emit dropRequested(); })};

  above_ = new FittedText;
  below_ = new FittedText;
  for (FittedText* text : {above_, below_})
    connect(text, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& url) { emit planeChosen(PlaneLabel{url.path().toUInt()}); });
  matrix_ = new ClassMatrix;
  auto* inner = new QWidget;
  inner->setBackgroundRole(QPalette::Base);
  inner->setAutoFillBackground(true);
  auto* pages = new QVBoxLayout(inner);
  pages->setContentsMargins(0, 0, 0, 0);
  pages->setSpacing(0);
  pages->addWidget(above_);
  pages->addWidget(matrix_);
  pages->addWidget(below_);
  pages->addStretch();
  scroll_ = new QScrollArea;
  scroll_->setWidget(inner);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(scroll_, 1);
  refresh();
}

void ComparePanel::setResult(const Comparer::Result& result) {
  result_ = result;
  refresh();
}

void ComparePanel::setMode(CompareMode mode) {
  modes_->setCurrentIndex(static_cast<int>(mode));
}

QString ComparePanel::plainText() const {
  return above_->toPlainText() + '\n' + below_->toPlainText();
}

void ComparePanel::refresh() {
  const bool there = result_.comparison != nullptr;
  modes_->setEnabled(there);
  for (QToolButton* button : needA_) button->setEnabled(there);
  matrix_->setVisible(there);
  matrix_->set(result_.comparison);
  const QString muted = mutedText(palette()).name();
  const int place = scroll_->verticalScrollBar()->value();
  above_->show(there ? upperPage(result_, muted)
                     : QStringLiteral("<p style='color:%1'>%2</p>")
                           .arg(muted, tr("Keep the present result as A and go on tuning: this page tells "
                                          "what changed.")));
  below_->setVisible(there);
  below_->show(there ? lowerPage(result_, muted) : QString());
  scroll_->verticalScrollBar()->setValue(place);
}

void ComparePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();
}

}  // namespace stratascope
