// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <GL/glew.h> // before any other GL header
#include <common/interfaces.h>
#include <QObject>

// Drives MeshLab from a script, for tests and pictures: see README.md. A decoration plugin without decorations, only to
// be loaded; it does nothing unless the environment variable LAPLACIAN_LINES_DRIVER names a script.
class DriverPlugin : public QObject, public MeshDecorateInterface
{
	Q_OBJECT
	MESHLAB_PLUGIN_IID_EXPORTER(MESH_DECORATE_INTERFACE_IID)
	Q_INTERFACES(MeshDecorateInterface)
public:
	DriverPlugin();

	using MeshDecorateInterface::decorationInfo;
	using MeshDecorateInterface::decorationName;
	QString pluginName() const override { return "LaplacianLinesDriver"; }
	QString decorationName(FilterIDType) const override { return {}; }
	QString decorationInfo(FilterIDType) const override { return {}; }
	int getDecorationClass(QAction*) const override { return PerMesh; }
	void decorateMesh(QAction*, MeshModel&, const RichParameterList*, GLArea*, QPainter*, GLLogStream&) override {}
	void decorateDoc(QAction*, MeshDocument&, const RichParameterList*, GLArea*, QPainter*, GLLogStream&) override {}
};
